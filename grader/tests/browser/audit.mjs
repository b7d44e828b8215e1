// audit.mjs [--shots DIR] PAGE.html...: opens each page from its file, light and dark, wide and narrow. Prints a line for
// each thing that is wrong: an axe-core violation, a broken picture, a message on the console, a request to
// a network, a page wider than the window. Exit status 1 when there is any. --shots keeps a picture of each view.
import { mkdirSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { launch, open, violations } from "./browser.mjs";

const views = [
  { name: "light", axe: true },
  { name: "dark", dark: true, axe: true },
  { name: "narrow", width: 360, height: 740 },
];

async function look(browser, file, view, shots) {
  const page = await open(browser, pathToFileURL(file).href, view);
  // Pictures that wait for the reader are fetched now.
  await page.evaluate(() => Promise.all([...document.images].map((image) => {
    image.loading = "eager";
    return image.decode().catch(() => {});
  })));
  const wrong = [...page.misdeeds];
  const broken = () => [...document.images].filter((image) => !image.naturalWidth).map((image) => image.src);
  for (const source of await page.evaluate(broken)) wrong.push(`broken picture ${source}`);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  if (wide > 0) wrong.push(`wider than the window by ${wide} px`);
  const found = view.axe ? await violations(page) : "";
  if (found) wrong.push(...found.split("\n").map((line) => `axe ${line.trim()}`));
  if (shots) await page.screenshot({ path: path.join(shots, `${path.basename(file, ".html")}-${view.name}.png`) });
  await page.context().close();
  return wrong;
}

const files = process.argv.slice(2);
const shots = files[0] === "--shots" ? files.splice(0, 2)[1] : undefined;
if (shots) mkdirSync(shots, { recursive: true });
const browser = await launch();
let count = 0;
for (const view of views)
  for (const file of files)
    for (const line of await look(browser, path.resolve(file), view, shots)) {
      console.log(`${file} (${view.name}): ${line}`);
      count++;
    }
await browser.close();
process.exit(count ? 1 : 0);
