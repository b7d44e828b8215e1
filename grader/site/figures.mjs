// The figures to play with, in the pages of the labs: one script a page, its parts wrapped one after another. It needs no
// network and no other file.
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
  return `"use strict";\n${[...parts.values()].join("\n")}\nconst { figure } = ${code}\nof_play.play(figure, document.querySelector(".play"));\ndocument.querySelectorAll(".frames").forEach(of_play.frames);\n`;
}

// The real frames of a lab (frames.mjs), or nothing where they are not made. `picture` copies one and returns its address.
function frames(lab, picture) {
  const folder = `build/frames/${lab}`;
  if (!existsSync(`${folder}/frames.json`)) return "";
  return JSON.parse(readFileSync(`${folder}/frames.json`, "utf8")).map(({ title, about, label, unit, frames: all }, number) => {
    const percent = (share) => `${(100 * share).toFixed(2)} %`;
    const pictures = all.map(({ value }, i) =>
      `<img data-frame="${i}" hidden src="${picture(`${folder}/${number}/${i}.png`)}" width="480" height="360" alt="${label} ${value}">`);
    const numbers = all.map(({ value, shadow, light }, i) =>
      `<div data-frame="${i}" data-words="${value}${unit}" hidden><dl><div><dt>false shadow</dt><dd>${percent(shadow)}</dd></div><div><dt>false light</dt><dd>${percent(light)}</dd></div></dl></div>`);
    return `<figure class="frames" hidden><figcaption><strong>${title}</strong> ${about}</figcaption>
${pictures.join("\n")}
<label><span>${label}</span><input type="range" min="0" max="${all.length - 1}" value="0"><output></output></label>
<div aria-live="polite">${numbers.join("")}</div></figure>
`;
  }).join("");
}

// What the page of a lab needs beside its text, or undefined where the lab has no figure: the page's HTML with the figure
// behind the first diagram, or at its end; the style; the script.
export function withFigure(html, lab, picture) {
  const file = ["solutions", "grader/recorded/figures"].map((folder) => `${folder}/${lab}/figure.mjs`).find(existsSync);
  if (!file) return undefined;
  const code = script(file);
  const figure = `<figure class="play" hidden></figure>\n<script type="module">${code}</script>\n`; // a module runs when the page is there
  const diagram = html.match(/<p><img src="[^"]*\.svg"[^>]*><\/p>\n/);
  const at = diagram ? diagram.index + diagram[0].length : html.length;
  const real = frames(lab, picture), rest = html.slice(at), wrong = rest.indexOf('<h2 id="what-goes-wrong');
  const behind = wrong < 0 ? real + rest : rest.slice(0, wrong) + real + rest.slice(wrong);
  const scope = ".play svg ";
  return {
    html: html.slice(0, at) + figure + behind,
    style: `${here("figures.css")}${rules(palettes.light, scope)}\n@media screen and (prefers-color-scheme: dark) {\n${rules(palettes.dark, scope)}\n}\n`,
    scripts: [code],
  };
}
