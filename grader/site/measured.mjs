// What was measured, where it is there, is part of the site: the study's chart, and the rows of the stability suite.
import { copyFileSync, existsSync, mkdirSync, readFileSync } from "node:fs";
import path from "node:path";

const from = (name) => `build/study/${name}.html`;

function copy(name, output) {
  mkdirSync(path.join(output, "measured"), { recursive: true });
  copyFileSync(from(name), path.join(output, "measured", `${name}.html`));
  return `measured/${name}.html`;
}

// Copies what there is of a lab to the site, and returns the links to it: { address, words }.
export function measured(lab, output) {
  const links = [];
  if (existsSync(from("chart")) && existsSync(`solutions/${lab}/study.c`))
    links.push({ address: copy("chart", output), words: "Speed against error: each method in many settings" });
  const text = existsSync(from("stability")) ? readFileSync(from("stability"), "utf8") : "";
  for (const [, id, number, words] of text.matchAll(/<section id="(row-(\d+))"><h2>\d+\. ([^<]*)/g))
    if (Math.floor(number / 100) === Number(lab.slice(0, 2)))
      links.push({ address: `${copy("stability", output)}#${id}`, words: `Where methods break: ${words.trim()}` });
  return links;
}
