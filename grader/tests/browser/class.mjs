// class.mjs OUT: uses the pages of a class run as people do, by keyboard and by mouse. audit.mjs looks at them otherwise.
import { readdirSync, readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const out = process.argv[2];
const url = (path) => pathToFileURL(`${out}/${path}`).href;
const pages = readdirSync(`${out}/pages`);
let passed = 0, failed = 0;
function check(name, ok, detail = "") {
  if (ok) passed++;
  else {
    failed++;
    console.log(`FAILED: ${name}\n    ${detail}`);
  }
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
});
const dialogs = [];
async function open(path) {
  const page = await browser.newPage({ viewport: { width: 1200, height: 900 } });
  page.on("dialog", (dialog) => { dialogs.push(dialog.message()); dialog.dismiss(); });
  await page.goto(url(path));
  return page;
}

// The slider: half of each, then by keys, then by mouse.
const page = await open(`pages/${pages.find((name) => readFileSync(`${out}/pages/${name}`, "utf8").includes("data-compare"))}`);
const clip = () => page.evaluate(() => getComputedStyle(document.querySelector(".compare img + img")).clipPath);
const slider = page.locator("input[data-compare]").first();
const focused = () => slider.evaluate((element) => element === document.activeElement);
const before = await clip();
for (let presses = 0; presses < 50 && !(await focused()); presses++) await page.keyboard.press("Tab");
check("the slider is reached by Tab", await focused());
await page.keyboard.press("End");
check("End shows all of yours", before.includes("50%") && (await clip()).includes("100%"), `${before}, ${await clip()}`);
await page.keyboard.press("ArrowLeft");
check("an arrow moves it by one", (await clip()).includes("99%"), await clip());
check("it says what is seen", (await slider.getAttribute("aria-valuetext")) === "99 % yours, 1 % reference");
const box = await slider.boundingBox();
await page.mouse.click(box.x + box.width * 0.25, box.y + box.height / 2);
const quarter = parseFloat((await clip()).match(/([\d.]+)%/)[1]);
check("the mouse moves it", Math.abs(quarter - 25) < 4, `${quarter} %`);
check("two different pictures of one size lie there", await page.evaluate(() => {
  const [yours, reference] = document.querySelectorAll(".compare img");
  return yours.naturalWidth > 0 && yours.naturalWidth === reference.naturalWidth && yours.src !== reference.src;
}));

// The index: sorting, by key and by mouse, and a link to a page.
const index = await open("index.html");
const table = index.locator("table").last();
const rows = () => table.locator("tbody tr").evaluateAll((list) => list.map((row) => [...row.cells].map((cell) => cell.textContent)));
const scores = async () => (await rows()).map((row) => Number(row[1]));
const first = await rows();
await table.locator("th button").nth(1).focus();
await index.keyboard.press("Enter");
const up = await scores();
check("Enter sorts by score", up.every((score, i) => i === 0 || up[i - 1] <= score) && up[0] < up.at(-1), up.join(" "));
await table.locator("th button").nth(1).click();
const down = await scores();
check("a second time turns it round", down.every((score, i) => i === 0 || down[i - 1] >= score), down.join(" "));
check("sorting loses no row", first.length === down.length && first.length === pages.length, `${first.length} ${down.length}`);
const bins = await index.locator("table").first().locator("tbody td.number").allTextContents();
check("the distribution counts everybody", bins.reduce((sum, text) => sum + Number(text), 0) === pages.length, bins.join(" "));
await table.locator("tbody a").first().click();
check("a name leads to its page", /\/pages\/.*\.html$/.test(index.url()), index.url());
check("no name is run as a script", dialogs.length === 0, dialogs.join(" "));
await browser.close();
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed ? 1 : 0;
