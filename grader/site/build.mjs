// build.mjs OUTPUT: turns the project's README files into a static site. Run in the project's folder by `make site`.
import {
  copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync,
} from "node:fs";
import path from "node:path";
import { withFigure } from "./figures.mjs";
import { escape, render } from "./pages.mjs";

const output = process.argv[2];
const read = (name) => readFileSync(new URL(name, import.meta.url), "utf8");
const shell = read("../pages/shell.html"), style = read("../pages/base.css") + read("style.css");
const policy = "img-src 'self' file: data:";

// What each room of the grader says of itself: its README first, and then its tables.
function rooms() {
  const group = "Rooms of the grader";
  const folders = readdirSync("grader").filter((name) => statSync(`grader/${name}`).isDirectory()).sort();
  return folders.flatMap((room) => {
    const tables = readdirSync(`grader/${room}`).filter((name) => name.endsWith(".md") && !["README.md", "slides.md"].includes(name)).sort();
    const page = (name, file) => ({ source: `grader/${room}/${name}`, file: `grader-${room}${file}.html`, group });
    return [
      ...(existsSync(`grader/${room}/README.md`) ? [page("README.md", "")] : []),
      ...tables.map((name) => page(name, `-${name.slice(0, -3).toLowerCase()}`)),
    ];
  });
}

// The pages in the order of the lectures.
const labs = readdirSync("labs").filter((name) => /^\d\d-[a-z-]+$/.test(name)).sort();
const pages = [
  { source: "README.md", file: "index.html", label: "Start" },
  ...labs.map((name) => ({ source: `labs/${name}/README.md`, file: `${name}.html`, group: "Labs" })),
  { source: "grader/site/slides.md", file: "slides.html", group: "More" },
  { source: "common/DEBUGGING.md", file: "debugging.html", group: "More" },
  ...[".github/CONTRIBUTING.md"].filter(existsSync).map((source) => ({ source, file: "contributing.html", group: "More" })),
  { source: "grader/README.md", file: "grader.html", group: "More" },
  ...rooms(),
];
const listings = new Map(); // files of the project that a page links to, shown as they are

process.on("uncaughtException", (error) => {
  console.error(`site: ${error.message}`);
  process.exit(1);
});

const site = {
  partial: !existsSync("solutions"),
  picture(file) {
    const target = path.join("pictures", file.replace(/^(labs|build)\//, ""));
    mkdirSync(path.join(output, path.dirname(target)), { recursive: true });
    copyFileSync(file, path.join(output, target));
    return target.split(path.sep).map(encodeURIComponent).join("/");
  },
  link(file) {
    const page = pages.find(({ source }) => source === file || source === path.join(file, "README.md"));
    if (page) return page.file;
    if (!existsSync(file) || !statSync(file).isFile()) return undefined;
    listings.set(file, `file-${file.replace(/[^\w.-]/g, "-")}.html`);
    return listings.get(file);
  },
};

function navigation(current) {
  let group, html = "";
  for (const { file, label, group: itsGroup } of pages) {
    if (itsGroup !== group) html += `${group || html ? "</ul>" : ""}${itsGroup ? `<p>${itsGroup}</p>` : ""}<ul>`;
    else if (!html) html += "<ul>";
    group = itsGroup;
    html += `<li><a href="${file}"${file === current ? ' aria-current="page"' : ""}>${label}</a></li>`;
  }
  return `${html}</ul>`;
}

function turn(page) {
  const at = pages.indexOf(page);
  const link = (to, rel, words) =>
    to ? `<a rel="${rel}" href="${to.file}"><span>${words}</span>${to.label}</a>` : "<span></span>";
  const links = link(pages[at - 1], "prev", "Previous") + link(pages[at + 1], "next", "Next");
  return at < 0 ? "" : `<nav class="turn" aria-label="Previous and next page">${links}</nav>`;
}

function write(page, title, html) {
  const name = title === "Shadow Lab" ? title : `${title} - Shadow Lab`;
  const content = `<a class="skip" href="#text">To the text</a>
<nav class="site" aria-label="All pages">${navigation(page.file)}</nav>
<main id="text">
${html}${turn(page)}
</main>
`;
  const { play } = page;
  const holes = {
    policy: play ? `${play.policy}; ${policy}` : policy, title: name, style: play ? style + play.style : style, content,
  };
  writeFileSync(path.join(output, page.file), shell.replace(/{{(\w+)}}/g, (_, hole) => holes[hole]));
}

rmSync(output, { recursive: true, force: true });
mkdirSync(output, { recursive: true });
for (const page of pages) {
  Object.assign(page, render(page.source, site));
  page.play = withFigure(page.html, path.basename(page.file, ".html"));
  page.label ??= escape(page.title.replace(/^Lab (\d\d): /, "$1 "));
}
for (const page of pages) write(page, page.title, page.play?.html ?? page.html);
for (const [file, target] of listings) {
  const text = escape(readFileSync(file, "utf8"));
  write({ file: target }, file, `<h1>${escape(file)}</h1>\n<pre tabindex="0" class="listing"><code>${text}</code></pre>\n`);
}
const first = path.join(output, "index.html");
console.log(`site: ${pages.length} pages and ${listings.size} listings in ${output}; open ${first}`);
