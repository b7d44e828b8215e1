// chart.mjs PAGE: the page of a study, by keyboard and by mouse.
import { pathToFileURL } from 'node:url';
import { behaves, check, finish, launch, open } from './browser.mjs';

const url = pathToFileURL(process.argv[2]).href;
const browser = await launch();

await behaves(browser, url, 'the chart', (page) => page.waitForFunction(() => document.querySelectorAll('canvas').length > 0));

const page = await open(browser, url);
const points = page.locator('[role=option]');
const title = () => page.locator('h3').first().innerText();
const named = async (point) => (await point.getAttribute('aria-label')).split(/, (?:no )?lab/)[0];
const count = await points.count();
check('the table holds each point', (await page.locator('tbody tr').count()) > count && count > 10, `${count} points`);

// How many pixels of the error's picture are more blue than red, and the other way round.
const tinted = async () => {
    await page.waitForTimeout(300); // pictures are decoded aside
    return page.evaluate(() => {
        const canvas = document.querySelector('canvas'), { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        const tints = { blue: 0, yellow: 0 };
        for (let i = 0; i < data.length; i += 4) {
            tints.blue += data[i + 2] > data[i] + 60;
            tints.yellow += data[i] > data[i + 2] + 60;
        }
        return tints;
    });
};

// By mouse: lab 07's z-pass takes light for shadow nearly everywhere; z-fail errs only where an edge cuts a pixel. Each has two points, which may lie on each
// other.
const wrong = page.locator('[aria-label^="z-pass"][aria-label*="lab 07"]').first(), right = page.locator('[aria-label^="z-fail"]').first();
const mark = (point) => point.locator('circle').last(); // no other mark lies on its middle, but bars may
await mark(wrong).click({ force: true });
check('a click shows the point', (await title()).startsWith('z-pass'), await title());
const dark = await tinted();
await mark(right).click({ force: true });
check('a click shows another point', (await title()).startsWith('z-fail'), await title());
const exact = await tinted();
check('false shadow is blue', dark.blue > 1000 && exact.blue + exact.yellow < dark.blue / 10, `${JSON.stringify(dark)} ${JSON.stringify(exact)}`);

// By keyboard, from the start: Tab reaches the one point that is selected, the arrows move on.
await page.locator('#figure').focus();
await page.keyboard.press('Tab');
const focused = () => page.evaluate(() => document.activeElement.getAttribute('aria-label'));
const selected = await page.locator('[aria-selected=true]').getAttribute('aria-label');
check('Tab reaches the selected point', (await focused()) === selected, `${await focused()}, not ${selected}`);
await page.keyboard.press('Home');
check('Home shows the fastest', (await title()).startsWith(await named(points.first())), await title());
await page.keyboard.press('ArrowRight');
check('an arrow shows the next', (await title()).startsWith(await named(points.nth(1))), await title());
await page.keyboard.press('End');
check('End shows the slowest', (await title()).startsWith(await named(points.last())), await title());
const stops = await page.locator('[role=option][tabindex="0"]').count();
check('one point of the chart is a stop of Tab', stops === 1, `${stops}`);

// The time of the picture alone: other times, the same setting stays selected.
const before = await title(), label = await focused();
await page.locator('#across').selectOption('shade');
const after = await page.locator('[aria-selected=true]').getAttribute('aria-label');
check('the other time is shown for the same setting', (await title()) === before && after !== label, `${label} ${after}`);

// Another figure of error: the marks move, the same setting stays selected.
const height = async () => page.locator('[aria-selected=true] .halo').getAttribute('cy');
const high = await height();
await page.locator('#figure').selectOption('flip');
check('another figure moves the marks', (await title()) === before && (await height()) !== high, `${high} ${await height()}`);

// No mark hides another one.
const hidden = await page.evaluate(() => {
    const marks = [...document.querySelectorAll('.point .halo')].map((halo) => [halo.cx.baseVal.value, halo.cy.baseVal.value]);
    return marks.filter(([x, y], i) => marks.some(([u, v], j) => j < i && Math.hypot(x - u, y - v) < 8)).length;
});
check('no mark hides another one', hidden === 0, `${hidden} do`);

// The counted cost: all but what rays trace, and the axis says so.
const times = await points.count();
await page.locator('#across').selectOption('cost');
const costs = await points.count(), drawn = await page.locator('svg[role=group]').first().textContent();
check('the cost stands in the place of time', costs > 5 && costs < times && drawn.includes('counted cost a pixel'), `${costs} of ${times}`);
check('nothing went wrong', page.misdeeds.length === 0, page.misdeeds.join('\n    '));
await browser.close();
finish();
