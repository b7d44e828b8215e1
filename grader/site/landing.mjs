// The first page: what each lab is, in the order of the course, from the table of labs in README.md and from the handouts.
import { readFileSync } from "node:fs";
import { labRow } from "./parts.mjs";
import { prose } from "./pages.mjs";
import { told } from "./progress.mjs";

// One lab: its picture, its name, a sentence, and what it needs.
function card({ file, title, picture, what, needs, hours, alt, progress }) {
  const facts = [needs && needs !== "-" ? `after lab ${needs}` : "", hours ? `${hours} hours` : ""].filter(Boolean);
  const image = picture.address ? `<img src="${picture.address}" alt="${alt}"${picture.size} loading="lazy">` : "";
  const sentence = what ? `${what[0].toUpperCase()}${what.slice(1)}.` : "";
  return `<li><a href="${file}">${image}<strong>${title}</strong></a>
<p>${prose(sentence)}</p>${facts.length ? `<p class="quiet">${facts.join(", ")}</p>` : ""}${
    told(progress) ? `<p class="${progress.done ? "done" : "begun"}">${told(progress)}</p>` : ""}</li>`;
}

// How far the student is in all labs, and where to go on; "" before the first point.
function summary(labs) {
  const begun = labs.filter(({ progress }) => told(progress)), next = labs.find(({ progress }) => !progress?.done);
  if (!begun.length) return "";
  const points = begun.reduce((sum, { progress }) => sum + progress.score, 0), done = begun.filter(({ progress }) => progress.done).length;
  const way = next ? `; next is <a href="${next.file}">lab ${next.title}</a>` : "";
  return `<p class="progress">${done} of ${labs.length} labs done, ${Math.floor(points)} points${way}. <span class="quiet">(As it was when these pages were made.)</span></p>\n`;
}

// `introduction` and `order` are HTML; `labs` as card takes them; `ways` links to what else a student needs.
export function landing({ introduction, order, labs, ways }) {
  const links = ways.map(({ file, label, what }) => `<li><a href="${file}">${label}</a>: ${what}</li>`).join("\n");
  return `<h1>Shadow Lab</h1>
${introduction}
<ul class="ways">
${links}
</ul>
<h2 id="the-labs">The labs</h2>
${summary(labs)}${order}
<ul class="cards">
${labs.map(card).join("\n")}
</ul>
`;
}

// The row of a lab in the table of README.md; in its place, where there is none, the first sentence of the handout's goal.
export function describe(readme, source) {
  const row = labRow(readme, source);
  if (row) return row;
  const goal = readFileSync(source, "utf8").match(/^## Goal\s+([^]*?[.?!])(?=\s)/m);
  return { what: goal ? goal[1].slice(0, -1).replace(/\s+/g, " ") : "" };
}
