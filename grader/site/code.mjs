// Colours for code: highlight.js marks the words at build time, style.css has the colours.
import highlighter from "highlight.js/lib/core";
import bash from "highlight.js/lib/languages/bash";
import c from "highlight.js/lib/languages/c";
import glsl from "highlight.js/lib/languages/glsl";
import javascript from "highlight.js/lib/languages/javascript";
import json from "highlight.js/lib/languages/json";
import makefile from "highlight.js/lib/languages/makefile";
import python from "highlight.js/lib/languages/python";

for (const [name, language] of Object.entries({ bash, c, glsl, javascript, json, makefile, python }))
  highlighter.registerLanguage(name, language);
highlighter.registerAliases(["sh", "shell"], { languageName: "bash" });
highlighter.registerAliases(["h"], { languageName: "c" });
highlighter.registerAliases(["frag", "vert", "geom"], { languageName: "glsl" });
highlighter.registerAliases(["mjs", "js"], { languageName: "javascript" });
highlighter.registerAliases(["py"], { languageName: "python" });

// `text` as HTML, in the colours of the language; escaped and without colours where it is not known.
export function colored(text, language, escape) {
  return language && highlighter.getLanguage(language) ? highlighter.highlight(text, { language }).value : escape(text);
}

// By the name of a file.
export function languageOf(file) {
  if (/(^|\/)Makefile$|\.mk$/.test(file)) return "makefile";
  return file.match(/\.(\w+)$/)?.[1];
}
