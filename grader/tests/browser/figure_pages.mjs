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

// What a point dragged to where the pointer was last makes of the state, by the figure's own box and rule.
async function dragged(page, figure, name) {
    const state = start(figure), { box: [[left, bottom], [right, top]] } = figure.points[name];
    for (const [x, y] of await page.evaluate(() => globalThis.way)) {
        const { origin, unit } = figure.view, at = [(x - origin[0]) / unit, (origin[1] - y) / unit];
        state[name] = [Math.min(Math.max(at[0], left), right), Math.min(Math.max(at[1], bottom), top)];
        for (const [each, { keep }] of Object.entries(figure.points)) if (keep) state[each] = keep(state[each], state);
    }
    return expected(figure, state);
}

// From here on the page notes where the pointer went, in units of the drawing.
const watchPointer = (page) => page.evaluate(() => {
    globalThis.way = [];
    const note = (event) => {
        const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(document.querySelector('.play svg').getScreenCTM().inverse());
        if (event.buttons) globalThis.way.push([x, y]);
    };
    document.addEventListener('pointermove', note, true);
});

// Each point once: `move` drags the grip by some pixels. The numbers are those of the place where it was left.
async function drag(page, figure, lab, how, move) {
    await watchPointer(page);
    for (const grip of await page.locator('.grip:visible').all()) {
        const name = await grip.getAttribute('data-point');
        await grip.scrollIntoViewIfNeeded();
        const { x, y, width, height } = await grip.boundingBox(), first = await grip.getAttribute('aria-valuetext');
        const scrolled = await page.evaluate(() => { globalThis.way = []; return scrollY; });
        await move(x + width / 2, y + height / 2);
        const then = await grip.getAttribute('aria-valuetext'), [now, wanted] = [await numbers(page), await dragged(page, figure, name)];
        check(`${lab}: ${how} drags ${name}`, first !== then, then);
        check(`${lab}: the numbers where ${how} left ${name}`, same(now, wanted), `${now}, not ${wanted}`);
        check(`${lab}: the page stays where it is`, (await page.evaluate(() => scrollY)) === scrolled);
        await page.locator('.play button').click();
    }
}

const byMouse = (page) => async (x, y) => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (const step of [10, 25, 40]) await page.mouse.move(x - step, y + step / 2);
    await page.mouse.up();
};

const byFinger = (client) => async (x, y) => {
    const touch = (type, step) => client.send('Input.dispatchTouchEvent', { type, touchPoints: type === 'touchEnd' ? [] : [{ x: x - step, y: y + step / 2 }] });
    await touch('touchStart', 0);
    for (const step of [8, 16, 24]) await touch('touchMove', step);
    await touch('touchEnd', 0);
};

// A phone: the points by a finger, and a slider by a tap on its end.
async function touch(phone, figure, lab) {
    await drag(phone, figure, lab, 'a finger', byFinger(await phone.context().newCDPSession(phone)));
    const slider = phone.locator('.play input[type=range]:visible').first();
    if (!(await slider.count())) return;
    await slider.scrollIntoViewIfNeeded();
    const { x, y, width, height } = await slider.boundingBox(), name = await slider.getAttribute('data-knob');
    const most = figure.knobs[name].value < (figure.knobs[name].least + figure.knobs[name].most) / 2;
    await phone.touchscreen.tap(x + (most ? width - 3 : 3), y + height / 2);
    const value = Number(await slider.inputValue());
    check(`${lab}: a tap sets ${name}`, value !== figure.knobs[name].value, String(value));
    check(`${lab}: the numbers for ${name} = ${value}`, same(await numbers(phone), expected(figure, { ...start(figure), [name]: value })));
}

const phones = await browser.newContext({ viewport: { width: 390, height: 800 }, hasTouch: true, isMobile: true });
for (const lab of labs) {
    const { figure } = await import(pathToFileURL(`solutions/${lab}/figure.mjs`).href), url = pathToFileURL(`${site}/${lab}.html`).href;
    const page = await open(browser, url);
    page.setDefaultTimeout(5000);
    check(`${lab}: the numbers at the start`, same(await numbers(page), expected(figure, start(figure))), String(await numbers(page)));
    await turn(page, figure, lab);
    await keys(page, lab);
    await drag(page, figure, lab, 'the mouse', byMouse(page));
    check(`${lab}: nothing went wrong`, page.misdeeds.length === 0, page.misdeeds.join('\n    '));
    await page.context().close();
    const phone = await phones.newPage();
    await phone.goto(url);
    await touch(phone, figure, lab);
    await phone.close();
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
