// One page of Markdown as HTML: formulas, headings with anchors, tables that scroll, pictures with their size, links
// that lead to the site's pages.
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import path from "node:path";
import { colored } from "./code.mjs";
import { putFormulas, takeFormulas } from "./formulas.mjs";

const entities = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };
export const escape = (text) => text.replace(/[&<>"]/g, (letter) => entities[letter]);
// A text of one line as HTML: `code` is marked, and nothing else.
export const prose = (text) => escape(text).replace(/`([^`]+)`/g, "<code>$1</code>");
const unescape = (html) => html.replace(/&(lt|gt|quot|amp);/g, (_, name) => ({ lt: "<", gt: ">", quot: '"', amp: "&" })[name]);
const plain = (html) => html.replace(/<annotation[^]*?<\/annotation>/g, "").replace(/<[^>]*>/g, "");

function parse(markdown) {
  const html = execFileSync("cmark-gfm", ["--extension", "table"], { input: markdown, encoding: "utf8" });
  return html.replace(/<!-- raw HTML omitted -->\n?/g, "");
}

// Fenced code that names its language.
const colorCode = (html) => html.replace(/<code class="language-([\w-]+)">([^]*?)<\/code>/g,
  (_, language, code) => `<code>${colored(unescape(code), language, escape)}</code>`);

// The anchor of a heading.
export const slug = (words) => words.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "") || "section";

function addAnchors(html) {
  const used = new Set();
  return html.replace(/<h([2-4])>([^]*?)<\/h\1>/g, (_, level, inner) => {
    const words = slug(plain(inner));
    let id = words;
    for (let n = 2; used.has(id); n++) id = `${words}-${n}`;
    used.add(id);
    return `<h${level} id="${id}">${inner}</h${level}>`;
  });
}

// Width and height stand in a PNG's first chunk, and in an SVG's first tag.
function pictureSize(file) {
  const bytes = readFileSync(file);
  if (bytes.toString("latin1", 1, 4) === "PNG")
    return ` width="${bytes.readUInt32BE(16)}" height="${bytes.readUInt32BE(20)}"`;
  const tag = bytes.toString("utf8", 0, 2000).match(/<svg[^>]*>/)?.[0] ?? "";
  const [width, height] = ["width", "height"].map((name) => tag.match(new RegExp(`\\s${name}="(\\d+)(px)?"`))?.[1]);
  return width && height ? ` width="${width}" height="${height}"` : "";
}

// Renders the page's Markdown, or `markdown` in its place. `site` says where things go: site.picture(file) and
// site.link(file, hash) return the address of a file of the project (both relative to the project), or undefined when the
// site has none; in a site.partial (of the student's kit, which lacks some files) that is no error.
export function render(source, site, markdown = readFileSync(source, "utf8")) {
  const folder = path.dirname(source);
  const inProject = (address) => path.normalize(path.join(folder, decodeURI(address)));
  const { text, formulas } = takeFormulas(markdown);
  let html = putFormulas(addAnchors(colorCode(parse(text))), formulas, source);
  html = html.replace(/<img src="([^"]*)" alt="([^"]*)"[^>]*\/>/g, (_, address, alt) => {
    const file = inProject(address);
    if (!existsSync(file)) return `<em class="missing">${alt} (this picture is not made yet: ${escape(file)})</em>`;
    return `<img src="${site.picture(file)}" alt="${alt}"${pictureSize(file)}>`;
  });
  html = html.replace(/<a href="([^"#]*)(#[^"]*)?"/g, (whole, address, hash = "") => {
    if (/^[a-z]+:/.test(address) || address === "") return whole;
    const target = site.link(inProject(address), hash);
    if (!target && site.partial) return "<a"; // words without a link
    if (!target) throw new Error(`${source}: the link to ${address} leads nowhere`);
    return `<a href="${target}"`;
  });
  html = html.replace(/<code>((?:common|shaders)\/[\w./-]+)<\/code>/g, (whole, file) => {
    const target = /\.\w+$/.test(file) && existsSync(file) && site.link(file, "");
    return target ? `<a href="${target}">${whole}</a>` : whole;
  });
  html = html.replace(/<th([^>]*)><\/th>/g, "<td$1></td>"); // Markdown wants a head; an empty one heads nothing
  let table = 0;
  const scroll = () => `<div class="wide" role="region" tabindex="0" aria-label="Table ${++table}"><table>`;
  html = html.replace(/<table>/g, scroll);
  html = html.replace(/<\/table>/g, "</table></div>").replace(/<pre>/g, '<pre tabindex="0">');
  const displayed = /<p>(<span class="katex"><math[^>]*display="block"[^]*?<\/math><\/span>)<\/p>/g;
  html = html.replace(displayed, '<div class="formula" tabindex="0">$1</div>');
  const title = plain(html.match(/<h1>([^]*?)<\/h1>/)?.[1] ?? source);
  return { html, title };
}
