// audit.mjs [--shots DIR] PAGE.html...: opens each page from its file, light and dark, wide and narrow. Prints a line for
// each thing that is wrong: an axe-core violation, a broken picture, a message on the console, a request to
// a network, a page wider than the window. Exit status 1 when there is any. --shots keeps a picture of each view.
import { readFileSync, mkdirSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const views = [
  { name: "light", colorScheme: "light", width: 1200, height: 900, axe: true },
  { name: "dark", colorScheme: "dark", width: 1200, height: 900, axe: true },
  { name: "narrow", colorScheme: "light", width: 360, height: 740 },
];
const flags = [
  "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-component-update",
  "--disable-sync",
];

async function look(context, file, view, shots) {
  const wrong = [];
  const page = await context.newPage();
  page.on("console", (message) => message.type() === "error" && wrong.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => wrong.push(`script: ${error.message}`));
  page.on("request", (request) => /^(file|data|blob):/.test(request.url()) || wrong.push(`request to ${request.url()}`));
  await page.goto(pathToFileURL(file).href, { waitUntil: "load" });
  // Pictures that wait for the reader are fetched now.
  await page.evaluate(() => Promise.all([...document.images].map((image) => {
    image.loading = "eager";
    return image.decode().catch(() => {});
  })));
  const broken = () => [...document.images].filter((image) => !image.naturalWidth).map((image) => image.src);
  for (const source of await page.evaluate(broken)) wrong.push(`broken picture ${source}`);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  if (wide > 0) wrong.push(`wider than the window by ${wide} px`);
  if (view.axe) await page.evaluate(axe);
  const violations = view.axe ? (await page.evaluate(() => axe.run())).violations : [];
  for (const { id, help, nodes } of violations) wrong.push(`axe ${id}: ${help}: ${nodes.length}x, first ${nodes[0].html.slice(0, 120)}`);
  if (shots) await page.screenshot({ path: path.join(shots, `${path.basename(file, ".html")}-${view.name}.png`) });
  await page.close();
  return wrong;
}

const files = process.argv.slice(2);
const shots = files[0] === "--shots" ? files.splice(0, 2)[1] : undefined;
if (shots) mkdirSync(shots, { recursive: true });
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: flags });
let count = 0;
for (const view of views) {
  const context = await browser.newContext({ colorScheme: view.colorScheme, viewport: { width: view.width, height: view.height } });
  for (const file of files)
    for (const line of await look(context, path.resolve(file), view, shots)) {
      console.log(`${file} (${view.name}): ${line}`);
      count++;
    }
  await context.close();
}
await browser.close();
process.exit(count ? 1 : 0);
