// What stands around each page: the list of all pages, with the contents of this one, and the way to the next.
import { createHash } from "node:crypto";

// A page's policy lets its own scripts run, each by its hash, and no other.
function policy({ scripts = [] }) {
  const hashes = scripts.map((code) => `'sha256-${createHash("sha256").update(code).digest("base64")}'`);
  return `${hashes.length ? `script-src ${hashes.join(" ")}; ` : ""}img-src 'self' file: data:`;
}

// The headings of the second level.
function contents({ html }) {
  const heads = [...html.matchAll(/<h2 id="([^"]*)">([^]*?)<\/h2>/g)];
  if (heads.length < 2) return "";
  return `<ul class="contents">${heads.map(([, id, head]) => `<li><a href="#${id}">${head}</a></li>`).join("")}</ul>`;
}

function entry(page, current) {
  const here = page.file === current.file;
  const done = page.done ? ' <span class="done" title="done">✓</span>' : "";
  return `<li><a href="${page.file}"${here ? ' aria-current="page"' : ""}>${page.label}${done}</a>${here ? contents(page) : ""}</li>`;
}

// Groups but that of the labs are folded up, unless the page is one of theirs.
function group(name, members, current) {
  const list = `<ul>${members.map((page) => entry(page, current)).join("")}</ul>`;
  if (!name) return list;
  if (name !== "For teachers") return `<p>${name}</p>${list}`;
  return `<details${members.some(({ file }) => file === current.file) ? " open" : ""}><summary>${name}</summary>${list}</details>`;
}

function navigation(pages, current) {
  const names = [...new Set(pages.map((page) => page.group))];
  const groups = names.map((name) => group(name, pages.filter((page) => page.group === name), current)).join("\n");
  const form = current.file === "search.html" ? ""
    : '<form class="find" role="search" action="search.html"><input type="search" name="q" aria-label="Search all pages" placeholder="Search"></form>';
  return `<nav class="site" id="pages" aria-label="All pages">
<p class="bar"><a href="index.html">Shadow Lab</a><a class="unfold" href="#pages">All pages</a><a class="fold" href="#text">Close</a></p>
<div class="list">${form}
${groups}</div>
</nav>`;
}

function turn(pages, page) {
  const at = pages.findIndex(({ file }) => file === page.file);
  const link = (to, rel, words) =>
    to ? `<a rel="${rel}" href="${to.file}"><span>${words}</span>${to.label}</a>` : "<span></span>";
  const links = link(pages[at - 1], "prev", "Previous") + link(pages[at + 1], "next", "Next");
  return at < 0 ? "" : `<nav class="turn" aria-label="Previous and next page">${links}</nav>`;
}

// The whole page. `page` has file, title and html, and the style and the scripts (their texts) that it alone needs.
export function frame(page, pages, style, shell) {
  const name = page.title === "Shadow Lab" ? page.title : `${page.title} - Shadow Lab`;
  const content = `<a class="skip" href="#text">To the text</a>
${navigation(pages, page)}
<main id="text">
${page.html}${turn(pages, page)}
</main>
`;
  const holes = { policy: policy(page), title: name, style: style + (page.style ?? ""), content };
  return shell.replace(/{{(\w+)}}/g, (_, hole) => holes[hole]);
}
