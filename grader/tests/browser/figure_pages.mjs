// figure_pages.mjs SITE: the figures of the site in Chromium: each page shows what the figure's own functions say, a slider, the
// arrow keys, the mouse and a finger change it, nothing misbehaves. Without scripts the diagram is there and the figure is not.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { check, finish, launch, open } from './browser.mjs';
import { start } from '../../site/play.mjs';

const site = path.resolve(process.argv[2]);
const labs = readdirSync('solutions').filter((name) => existsSync(`solutions/${name}/figure.mjs`)).sort();
const browser = await launch();
const numbers = (page) => page.locator('.play dd').allTextContents();
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

// What the page shows for a state, by the functions themselves.
const expected = (figure, state) => figure.numbers(state).map(([, value]) => value);

// A knob by its keys: a slider goes to its least value, a choice to the next one.
async function turn(page, figure, lab) {
    const shown = Object.keys(figure.knobs).filter((key) => figure.knobs[key].when?.(start(figure)) ?? true);
    for (const name of shown) {
        const knob = figure.knobs[name], control = page.locator(`[data-knob=${name}]`), before = await numbers(page);
        await control.focus();
        await page.keyboard.press(knob.choices ? (knob.value ? 'ArrowUp' : 'ArrowDown') : knob.value > knob.least ? 'Home' : 'End');
        const value = Number(await control.inputValue()), now = await numbers(page);
        check(`${lab}: ${name} moves`, value !== knob.value);
        check(`${lab}: the numbers for ${name} = ${value}`, same(now, expected(figure, { ...start(figure), [name]: value })), String(now));
        await page.locator('.play button').click();
        check(`${lab}: back to the start`, same(await numbers(page), before));
    }
}

async function keys(page, lab) {
    const grip = page.locator('.grip').first(), where = () => grip.getAttribute('aria-valuetext');
    const first = await where();
    await grip.focus();
    for (const key of ['ArrowRight', 'ArrowUp', 'ArrowLeft', 'ArrowDown', 'ArrowRight']) await page.keyboard.press(key);
    check(`${lab}: arrow keys move a point`, (await where()) !== first, await where());
    await page.locator('.play button').click();
    check(`${lab}: and the button puts it back`, (await where()) === first, await where());
}

async function drag(page, lab) {
    for (const grip of await page.locator('.grip').all()) {
        const name = await grip.getAttribute('data-point');
        await grip.scrollIntoViewIfNeeded();
        const { x, y, width, height } = await grip.boundingBox(), at = [x + width / 2, y + height / 2], first = await grip.getAttribute('aria-valuetext');
        await page.mouse.move(...at);
        await page.mouse.down();
        for (const step of [10, 25, 40]) await page.mouse.move(at[0] - step, at[1] + step / 2);
        await page.mouse.up();
        const then = await grip.getAttribute('aria-valuetext');
        check(`${lab}: the mouse drags ${name}`, first !== then, then);
        await page.locator('.play button').click();
    }
}

async function finger(page, lab) {
    const grip = page.locator('.grip').first(), first = await grip.getAttribute('aria-valuetext');
    await grip.scrollIntoViewIfNeeded();
    const { x, y, width, height } = await grip.boundingBox(), client = await page.context().newCDPSession(page), at = [x + width / 2, y + height / 2];
    const touch = (type, step) => client.send('Input.dispatchTouchEvent', { type, touchPoints: type === 'touchEnd' ? [] : [{ x: at[0] + step, y: at[1] + step / 4 }] });
    await touch('touchStart', 0);
    for (const step of [8, 16, 24]) await touch('touchMove', step);
    await touch('touchEnd', 0);
    check(`${lab}: a finger drags a point`, (await grip.getAttribute('aria-valuetext')) !== first);
}

for (const [i, lab] of labs.entries()) {
    const { figure } = await import(pathToFileURL(`solutions/${lab}/figure.mjs`).href), url = pathToFileURL(`${site}/${lab}.html`).href;
    const page = await open(browser, url);
    page.setDefaultTimeout(5000);
    check(`${lab}: the numbers at the start`, same(await numbers(page), expected(figure, start(figure))), String(await numbers(page)));
    await turn(page, figure, lab);
    await keys(page, lab);
    await drag(page, lab);
    check(`${lab}: nothing went wrong`, page.misdeeds.length === 0, page.misdeeds.join('\n    '));
    await page.context().close();
    if (i % 4) continue; // a phone takes a while
    const context = await browser.newContext({ viewport: { width: 390, height: 800 }, hasTouch: true, isMobile: true }), phone = await context.newPage();
    await phone.goto(url);
    await finger(phone, lab);
    await context.close();
}

// Real frames, where they were made: one picture at a time, with the numbers of its line.
for (const lab of labs.filter((name) => existsSync(`build/frames/${name}/frames.json`))) {
    const [{ frames }] = JSON.parse(readFileSync(`build/frames/${lab}/frames.json`, 'utf8')), page = await open(browser, pathToFileURL(`${site}/${lab}.html`).href);
    const control = page.locator('.frames input').first(), shown = page.locator('.frames').first().locator('[data-frame]:visible');
    const words = ({ shadow, light }) => [shadow, light].map((share) => `${(100 * share).toFixed(2)} %`);
    const rows = () => page.locator('.frames').first().locator('dd:visible').allTextContents();
    check(`${lab}: the first frame`, (await shown.count()) === 2 && same(await rows(), words(frames[0])), String(await rows()));
    await control.focus();
    await page.keyboard.press('End');
    check(`${lab}: the last frame`, (await shown.count()) === 2 && same(await rows(), words(frames.at(-1))), String(await rows()));
    check(`${lab}: its picture is there`, await shown.first().evaluate((image) => image.naturalWidth > 0));
    await page.context().close();
}

// Without scripts: the diagram, and no empty frame.
const still = await browser.newContext({ javaScriptEnabled: false }), page = await still.newPage();
await page.goto(pathToFileURL(`${site}/${labs[0]}.html`).href);
check('without scripts no figure is shown', !(await page.locator('.play').isVisible()) && !(await page.locator('.frames:visible').count()));
check('without scripts the diagram is', await page.locator('main img[src$=".svg"]').first().isVisible());
await browser.close();
finish();
