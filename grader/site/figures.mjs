// The figures to play with, in the pages of the labs: one script a page, its parts wrapped one after another. It needs no
// network and no other file.
import { createHash } from "node:crypto";
import { existsSync, readFileSync } from "node:fs";
import { palettes, rules } from "./ink.mjs";

const here = (name) => readFileSync(new URL(name, import.meta.url), "utf8");

// A module as an expression whose value holds its exports. It may import by name from the modules of this folder: of_NAME.
function wrapped(text) {
  const names = [...text.matchAll(/^export (?:const|function) (\w+)/gm)].map((match) => match[1]);
  const imports = /^import \{([^}]*)\} from "[^"]*?([\w-]+)\.mjs";$/gm;
  const body = text.replace(imports, (_, list, module) => `const {${list.replace(/ as /g, ": ")}} = of_${module};`).replace(/^export /gm, "");
  return { needs: [...text.matchAll(imports)].map((match) => match[2]), code: `(() => {\n${body}\nreturn { ${names.join(", ")} };\n})();` };
}

// The script of the figure in `file`: all that it needs, the deepest first.
export function script(file) {
  const parts = new Map();
  const take = (name) => {
    if (parts.has(name)) return;
    const { needs, code } = wrapped(here(`${name}.mjs`));
    needs.forEach(take);
    parts.set(name, `const of_${name} = ${code}`);
  };
  const { needs, code } = wrapped(readFileSync(file, "utf8"));
  [...needs, "play"].forEach(take);
  return `"use strict";\n${[...parts.values()].join("\n")}\nconst { figure } = ${code}\nof_play.play(figure, document.querySelector(".play"));\n`;
}

// What the page of a lab needs beside its text, or undefined where the lab has no figure: the page's HTML with the figure
// behind the first diagram, or at its end; the style; what the page's policy must allow.
export function withFigure(html, lab) {
  const file = ["solutions", "grader/recorded/figures"].map((folder) => `${folder}/${lab}/figure.mjs`).find(existsSync);
  if (!file) return undefined;
  const code = script(file);
  const figure = `<figure class="play" hidden></figure>\n<script type="module">${code}</script>\n`;
  const diagram = html.match(/<p><img src="[^"]*\.svg"[^>]*><\/p>\n/);
  const at = diagram ? diagram.index + diagram[0].length : html.length;
  const scope = ".play svg ";
  return {
    html: html.slice(0, at) + figure + html.slice(at),
    style: `${here("figures.css")}${rules(palettes.light, scope)}\n@media screen and (prefers-color-scheme: dark) {\n${rules(palettes.dark, scope)}\n}\n`,
    policy: `script-src 'sha256-${createHash("sha256").update(code).digest("base64")}'`,
  };
}
