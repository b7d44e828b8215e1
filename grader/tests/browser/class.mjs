// class.mjs OUT: the pages of a class run, by keyboard and by mouse.
import { readdirSync, readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { behaves, check, finish, launch, open } from './browser.mjs';

const out = process.argv[2];
const url = (path) => pathToFileURL(`${out}/${path}`).href;
const pages = readdirSync(`${out}/pages`);
const wrong = pages.find((name) => readFileSync(`${out}/pages/${name}`, 'utf8').includes('data-compare'));
const refused = pages.find((name) => readFileSync(`${out}/pages/${name}`, 'utf8').includes('<h3>Message</h3>'));
check('there is a page with pictures, and one with a message', wrong && refused);
const browser = await launch();

// No page misbehaves, in no colours and at no width.
for (const path of ['index.html', `pages/${wrong}`, `pages/${refused}`])
    await behaves(browser, url(path), path);

// The slider: half of each, then by keys, then by mouse.
const page = await open(browser, url(`pages/${wrong}`));
const clip = () => page.evaluate(() => getComputedStyle(document.querySelector('.compare img + img')).clipPath);
const slider = page.locator('input[data-compare]').first();
const before = await clip();
for (let presses = 0; presses < 50 && !(await slider.evaluate((element) => element === document.activeElement)); presses++)
    await page.keyboard.press('Tab');
check('the slider is reached by Tab', await slider.evaluate((element) => element === document.activeElement));
await page.keyboard.press('End');
const all = await clip();
check('End shows all of yours', before.includes('50%') && all.includes('100%'), `${before}, ${all}`);
await page.keyboard.press('ArrowLeft');
check('an arrow moves it by one', (await clip()).includes('99%'), await clip());
check('it says what is seen', (await slider.getAttribute('aria-valuetext')) === '99 % yours, 1 % reference');
const box = await slider.boundingBox();
await page.mouse.click(box.x + box.width * 0.25, box.y + box.height / 2);
const quarter = parseFloat((await clip()).match(/([\d.]+)%/)[1]);
check('the mouse moves it', Math.abs(quarter - 25) < 4, `${quarter} %`);
const differs = await page.evaluate(() => {
    const [yours, reference] = document.querySelectorAll('.compare img');
    return yours.naturalWidth > 0 && yours.naturalWidth === reference.naturalWidth && yours.src !== reference.src;
});
check('two pictures of one size lie there', differs);

// The index: sorting, by key and by mouse, and a link to a page.
const index = await open(browser, url('index.html'));
const table = index.locator('table').last();
const rows = () => table.locator('tbody tr').evaluateAll((list) => list.map((row) => [...row.cells].map((cell) => cell.textContent)));
const first = await rows();
await table.locator('th button').nth(1).focus();
await index.keyboard.press('Enter');
const scores = (await rows()).map((row) => Number(row[1]));
check('Enter sorts by score', scores.every((score, i) => i === 0 || scores[i - 1] <= score), scores.join(' '));
await table.locator('th button').nth(1).click();
const down = (await rows()).map((row) => Number(row[1]));
check('a second time turns it round', down.every((score, i) => i === 0 || down[i - 1] >= score), down.join(' '));
check('sorting loses no row', first.length === down.length && first.length === pages.length, `${first.length} ${down.length}`);
const counts = await index.locator('table').first().locator('tbody td.number').allTextContents();
check('the labs count who handed in: all but one', Number(counts[0]) === pages.length - 1, counts.join(' '));
const spread = (await index.locator('.spread').first().getAttribute('aria-label')).match(/\d+(?= (from|with))/g);
check('the spread counts them, too', spread.reduce((sum, text) => sum + Number(text), 0) === pages.length - 1, spread.join(' '));
const glance = await index.locator('.glance tbody tr').count();
check('the glance has everybody', glance === pages.length, `${glance}`);
await table.locator('tbody a').first().click();
check('a name leads to its page', /\/pages\/.*\.html$/.test(index.url()) && index.misdeeds.length === 0, index.url());
await browser.close();
finish();
