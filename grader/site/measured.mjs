// What was measured, where it is there, is part of the site: the study's chart, and the rows of the stability suite.
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync } from "node:fs";
import path from "node:path";
import { escape } from "./pages.mjs";

const from = (name) => `build/study/${name}.html`;

function copy(name, output) {
  const to = path.join(output, "measured", `${name}.html`);
  mkdirSync(path.dirname(to), { recursive: true });
  if (!existsSync(to)) copyFileSync(from(name), to);
  return `measured/${name}.html`;
}

// The scenes of the chart in which a method of this lab stands, from a line of JSON each.
function charts(id, output) {
  if (!existsSync(from("chart"))) return [];
  const lines = readFileSync(from("chart"), "utf8").split("\n").filter((line) => line.includes(`"lab":"${id}"`));
  return lines.flatMap((line) => {
    const [, name, title] = line.match(/"name":"([^"]*)","title":"([^"]*)"/) ?? [];
    return name ? [{ address: `${copy("chart", output)}#${encodeURIComponent(name)}`, words: `Speed against error: ${escape(title)}` }] : [];
  });
}

// The numbers of the rows that the lab's files define. (Those of the first labs are small, and say nothing of the lab.)
function numbers(lab) {
  const files = existsSync(`solutions/${lab}`) ? readdirSync(`solutions/${lab}`).filter((name) => /^rows.*\.c$/.test(name)) : [];
  const texts = files.map((name) => readFileSync(`solutions/${lab}/${name}`, "utf8")).join("\n");
  return new Set([...texts.matchAll(/^ {4}\{(\d+), *\n? *"/gm)].map(([, number]) => number));
}

function rows(lab, output) {
  if (!existsSync(from("stability"))) return [];
  const own = numbers(lab), isOwn = (number) => own.has(number) || Math.floor(number / 100) === Number(lab.slice(0, 2));
  const heads = readFileSync(from("stability"), "utf8").matchAll(/<section id="(row-(\d+))"><h2>\d+\. ([^<]*)/g);
  return [...heads].filter(([, , number]) => isOwn(number))
    .map(([, id, , words]) => ({ address: `${copy("stability", output)}#${id}`, words: `Where methods break: ${words.trim()}` }));
}

// Copies what there is of a lab to the site, and returns the links to it: { address, words }.
export const measured = (lab, output) => [...charts(lab.slice(0, 2), output), ...rows(lab, output)];
