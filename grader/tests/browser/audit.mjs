// audit.mjs [--shots DIR] PAGE.html...: opens each page from its file and looks at it light and dark, wide and on a phone. Prints a
// line for each thing that is wrong: an axe-core violation, a broken picture, a message on the console, a request to a network, a page
// wider than the window, words outside of the window or cut off. Exit status 1 when there is any. --shots keeps a picture of each view.
import { mkdirSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { launch, open, violations } from "./browser.mjs";

// Other colours can only change the contrast, another width all but that: each rule is asked once for each.
const contrast = { runOnly: ["color-contrast"] }, others = { rules: { "color-contrast": { enabled: false } } };
const views = [
  { name: "light", width: 1200, height: 900, axe: {} },
  { name: "dark", width: 1200, height: 900, dark: true, axe: contrast },
  { name: "narrow-dark", width: 390, height: 844, dark: true },
  { name: "narrow", width: 390, height: 844, axe: others },
  { name: "narrowest", width: 320, height: 640 }, // a window of 1280 pixels at 400 %
];

// Words that nobody can bring into view: outside of the window with nothing to scroll them by, or cut off by their box.
function unseen() {
  const found = [], words = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const scrolls = (element) => element && (/auto|scroll/.test(getComputedStyle(element).overflowX) || scrolls(element.parentElement));
  while (words.nextNode()) {
    const { textContent: text, parentElement: parent } = words.currentNode, range = document.createRange();
    if (!text.trim() || !parent.checkVisibility() || parent.closest(".skip")) continue;
    range.selectNodeContents(words.currentNode);
    const outside = [...range.getClientRects()].some(({ left, right, width }) => width > 1 && (right > innerWidth + 1 || left < -1));
    if (outside && !scrolls(parent)) found.push(`"${text.trim().slice(0, 60)}" lies outside`);
  }
  for (const element of document.body.querySelectorAll("*"))
    if (getComputedStyle(element).overflowY === "hidden" && element.checkVisibility() && element.scrollHeight > element.clientHeight + 1)
      found.push(`"${element.textContent.trim().slice(0, 60)}" is cut off`);
  return found;
}

async function look(page, view) {
  await page.setViewportSize(view);
  await page.emulateMedia({ colorScheme: view.dark ? "dark" : "light" });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  const wrong = wide > 0 ? [`wider than the window by ${wide} px`] : [];
  const found = view.axe ? await violations(page, view.axe) : "";
  if (found) wrong.push(...found.split("\n").map((line) => `axe ${line.trim()}`));
  return [...wrong, ...await page.evaluate(unseen)];
}

const files = process.argv.slice(2);
const shots = files[0] === "--shots" ? files.splice(0, 2)[1] : undefined;
if (shots) mkdirSync(shots, { recursive: true });
const browser = await launch();
let count = 0;
for (const file of files) {
  const say = (name, lines) => lines.forEach((line) => { console.log(`${file} (${name}): ${line}`); count++; });
  const page = await open(browser, pathToFileURL(path.resolve(file)).href);
  // Pictures that wait for the reader are fetched now.
  await page.evaluate(() => Promise.all([...document.images].map((image) => {
    image.loading = "eager";
    return image.decode().catch(() => {});
  })));
  say("pictures", (await page.evaluate(() => [...document.images].filter((image) => !image.naturalWidth).map(({ src }) => src))).map((src) => `broken picture ${src}`));
  for (const view of views) {
    say(view.name, await look(page, view));
    if (shots) await page.screenshot({ path: path.join(shots, `${path.basename(file, ".html")}-${view.name}.png`), fullPage: process.env.FULL === "1" });
  }
  say("all", page.misdeeds);
  await page.context().close();
}
await browser.close();
process.exit(count ? 1 : 0);
