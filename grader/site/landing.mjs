// The first page: what each lab is, in the order of the course, from the table of labs in README.md and from the handouts.
import { readFileSync } from "node:fs";
import { labRow } from "./parts.mjs";
import { prose } from "./pages.mjs";

// One lab: its picture, its name, a sentence, and what it needs.
function card({ file, title, picture, what, needs, hours, alt }) {
  const facts = [needs && needs !== "-" ? `after lab ${needs}` : "", hours ? `${hours} hours` : ""].filter(Boolean);
  return `<li><a href="${file}"><img src="${picture.address}" alt="${alt}"${picture.size} loading="lazy"><strong>${title}</strong></a>
<p>${prose(what[0].toUpperCase() + what.slice(1))}.</p>${facts.length ? `<p class="quiet">${facts.join(", ")}</p>` : ""}</li>`;
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
${order}
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
