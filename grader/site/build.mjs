// build.mjs OUTPUT: turns the project's README files into a static site. Run in the project's folder by `make site`.
import {
  copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync,
} from "node:fs";
import path from "node:path";
import { colored, languageOf } from "./code.mjs";
import { withFigure } from "./figures.mjs";
import { addMistakes, gallery, withSliders } from "./gallery.mjs";
import { addMeasured, addSlides } from "./handout.mjs";
import { describe, landing } from "./landing.mjs";
import { frame } from "./layout.mjs";
import { measured } from "./measured.mjs";
import { escape, render, slug } from "./pages.mjs";
import { sections, slidesOfTasks } from "./parts.mjs";
import { progress } from "./progress.mjs";
import { search } from "./search.mjs";

const output = process.argv[2];
const read = (name) => readFileSync(new URL(name, import.meta.url), "utf8");
const style = read("../pages/base.css") + read("style.css");

process.on("uncaughtException", (error) => {
  console.error(`site: ${error.message}`);
  process.exit(1);
});

// README.md has a part for students and one for teachers; the student's kit has one for students only.
const readme = readFileSync("README.md", "utf8");
const { before, parts } = sections(readme);
const partOf = (head) => parts.find((part) => part.head === head);
const joined = (those) => those.map(({ head, body }) => `## ${head}${body}`).join("");
const forTeachers = partOf("For teaching assistants");
const others = parts.filter(({ head }) => !["The labs", "For students"].includes(head));
const students = partOf("For students")?.body.replace(/^###/gm, "##") ?? before.replace(/^# .*/, "") + joined(others);

// What each room of the grader says of itself: its README first, and then its tables.
function rooms() {
  const group = "For teachers";
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

// The pages in the order of the lectures; those without a source are made of others.
const folders = readdirSync("labs").filter((name) => /^\d\d-[a-z-]+$/.test(name)).sort();
const far = progress();
const labs = folders.map((name) => ({
  source: `labs/${name}/README.md`, file: `${name}.html`, group: "Labs", lab: name,
  folder: [`solutions/${name}`, `grader/recorded/${name}`].find(existsSync), // where answers and mistakes lie
  progress: far.get(name.slice(0, 2)), done: far.get(name.slice(0, 2))?.done,
}));
const start = { file: "index.html", label: "Start", title: "Shadow Lab" };
const wrong = { file: "wrong.html", label: "What goes wrong", title: "What goes wrong, and how it looks", group: "More" };
const finder = { file: "search.html", label: "Search", title: "Search", group: "More" };
const pages = [
  start,
  { source: "README.md", text: `# How to work\n${students}`, file: "students.html", label: "How to work" },
  ...labs,
  wrong,
  { source: "grader/site/slides.md", file: "slides.html", group: "More" },
  { source: "common/DEBUGGING.md", file: "debugging.html", group: "More" },
  finder,
  ...(forTeachers ? [{ source: "README.md", text: `# For teachers\n\n${joined(others)}`, file: "teachers.html", label: "The project", group: "For teachers" }] : []),
  ...[".github/CONTRIBUTING.md"].filter(existsSync).map((source) => ({ source, file: "contributing.html", group: "For teachers" })),
  { source: "grader/README.md", file: "grader.html", group: "For teachers" },
  ...rooms(),
];
const listings = new Map(); // files of the project that a page links to, shown as they are

// The page, and the place in it, that a link to README.md means.
function linkOfReadme(hash) {
  const heads = (text) => [...text.matchAll(/^#{2,4} (.*)/gm)].map(([, head]) => `#${slug(head)}`);
  if (hash === "#for-students") return "students.html";
  if (hash === "#the-labs") return "index.html#the-labs";
  const page = pages.find(({ text }) => text && heads(text).includes(hash));
  return hash && page ? page.file + hash : "index.html";
}

const site = {
  partial: !existsSync("solutions"),
  picture(file) {
    const target = path.join("pictures", file.replace(/^(labs|build)\//, ""));
    mkdirSync(path.join(output, path.dirname(target)), { recursive: true });
    copyFileSync(file, path.join(output, target));
    return target.split(path.sep).map(encodeURIComponent).join("/");
  },
  link(file, hash) {
    if (file === "README.md") return linkOfReadme(hash);
    const page = pages.find(({ source }) => source === file || source === path.join(file, "README.md"));
    if (page) return page.file + hash;
    if (!existsSync(file) || !statSync(file).isFile()) return undefined;
    listings.set(file, `file-${file.replace(/[^\w.-]/g, "-")}.html`);
    return listings.get(file) + hash;
  },
};

const slider = read("../pages/compare.js");

function decorate(page, slides) {
  const text = addSlides(addMistakes(page.html, page.lab, page.folder), slides);
  const sliding = withSliders(addMeasured(text, measured(page.lab, output)), slider);
  const { scripts = [], ...rest } = withFigure(sliding.html, page.lab, site.picture) ?? { html: sliding.html };
  return { ...rest, scripts: [...scripts, ...sliding.scripts] };
}

// The first picture of a page.
function firstPicture({ html }) {
  const [, address, alt, size] = html.match(/<img src="([^"]*)" alt="([^"]*)"((?: \w+="\d+")*)/) ?? [];
  return { picture: { address, size }, alt };
}

function makeStart() {
  const part = (text) => render("README.md", site, text).html;
  const paragraphs = (text, take) => part(text.split("\n\n").filter(take).join("\n\n"));
  let words = 0;
  const ways = [
    ["students.html", "the commands, the window, and what to hand in"],
    ["wrong.html", "wrong pictures, and what made them so"],
    ["slides.html", "which task follows which slide of a lecture"],
    ["debugging.html", "stages, numbers and a frame debugger: how to find out why"],
    ["teachers.html", "grading a class, the chart of speed against error, how it is built"],
  ].map(([file, what]) => ({ ...pages.find((page) => page.file === file), what })).filter(({ file }) => file);
  return landing({
    introduction: paragraphs(before, (text) => text.startsWith("![") || (/^[A-Z]/.test(text.trim()) && !words++)),
    order: paragraphs(partOf("The labs")?.body ?? "", (text) => /^[A-Z]/.test(text.trim())),
    labs: labs.map((page) => ({ file: page.file, title: page.label, progress: page.progress, ...firstPicture(page), ...describe(readme, page.source) })),
    ways,
  });
}

const write = (page) => writeFileSync(path.join(output, page.file), frame(page, pages, style, read("../pages/shell.html")));

rmSync(output, { recursive: true, force: true });
mkdirSync(output, { recursive: true });
for (const page of pages.filter(({ source }) => source)) {
  Object.assign(page, render(page.source, site, page.text));
  page.label ??= escape(page.title.replace(/^Lab (\d\d): /, "$1 "));
}
Object.assign(wrong, gallery(labs, slider));
const slides = slidesOfTasks(read("slides.md"));
for (const page of labs) Object.assign(page, decorate(page, slides));
start.html = makeStart();
Object.assign(finder, search(pages.filter(({ html }) => html), read("search.js")));
for (const page of pages) write(page);
for (const [file, target] of listings) {
  const text = colored(readFileSync(file, "utf8"), languageOf(file), escape);
  write({ file: target, title: escape(file), html: `<h1>${escape(file)}</h1>\n<pre tabindex="0" class="listing"><code>${text}</code></pre>\n` });
}
const first = path.join(output, "index.html");
console.log(`site: ${pages.length} pages and ${listings.size} listings in ${output}; open ${first}`);
