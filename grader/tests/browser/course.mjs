// course.mjs SITE: the site as a student uses it: the first page, the list of pages on a narrow screen, the search, the questions, wrong
// pictures and right ones under a slider.
import { readFileSync, readdirSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { check, finish, launch, open } from './browser.mjs';

const url = (name) => pathToFileURL(`${process.argv[2]}/${name}`).href;
const browser = await launch();

const start = await open(browser, url('index.html'));
const cards = await start.locator('.cards li').count();
check('a card for each lab', cards >= 13 && (await start.locator('.cards img').count()) === cards, `${cards}`);
await start.locator('.cards a').nth(2).click();
check('a card leads to its handout', /\/03-shadow-map\.html$/.test(start.url()), start.url());

// On a narrow screen the list is folded up, and unfolds by a link.
const narrow = await open(browser, url('03-shadow-map.html'), { width: 390, height: 800 });
const list = narrow.locator('nav.site .list');
check('folded up', !(await list.isVisible()));
check('the text begins on the first screen', (await narrow.locator('h1').boundingBox()).y < 200);
await narrow.getByRole('link', { name: 'All pages' }).click();
check('unfolded', await list.isVisible());
await narrow.locator('nav.site .contents a').first().click();
check('a heading of the page folds it up again', !(await list.isVisible()));

// The search: from any page, by keys, with nothing but files.
const page = await open(browser, url('05-pcf.html'));
await page.getByRole('searchbox').focus();
await page.keyboard.type('Polygon OFFSET');
await page.keyboard.press('Enter');
await page.waitForURL(/search\.html\?q=/);
const said = () => page.locator('#said').textContent();
const hits = () => page.locator('#found a').evaluateAll((links) => links.map((link) => link.getAttribute('href')));
check('lab 04 is found', (await hits()).some((link) => link.startsWith('04-acne-and-bias.html#')), (await hits()).join(' '));
check('as many as are said', (await said()).startsWith(`${(await hits()).length} `), await said());
await page.locator('#q').fill('no such word anywhere');
check('nothing is found', (await said()) === '0 sections' && !(await hits()).length, await said());
await page.locator('#q').fill('<img src=x onerror=alert(1)> [( \\');
check('signs are only signs', (await said()) === '0 sections' && !page.misdeeds.length, page.misdeeds.join(' '));
for (const odd of ['ß', '.*', '$&', 'İ', '\\b', '%', "it's", 'a'.repeat(5000)]) await page.locator('#q').fill(odd);
await page.locator('#q').fill('(4.1)');
check('signs of a pattern are found as they are', (await hits()).some((link) => link.startsWith('04-')) && !page.misdeeds.length, page.misdeeds.join(' '));
await page.locator('#q').fill('');
check('an empty question', !(await hits()).length);
await page.locator('#q').fill('acne');
await page.locator('#found a').first().click();
check('a hit leads to its section', /\.html(#|$)/.test(page.url()) && !page.misdeeds.length, page.url());

// Three questions, and no answer.
await page.goto(url('03-shadow-map.html'));
check('three questions', (await page.locator('#three-questions ~ ol').first().locator('> li').count()) === 3);
check('a slide stands at a task', (await page.locator('.chips li', { hasText: '000 10.3' }).count()) > 0);

// What goes wrong: each pair of pictures under a slider, by keys, by mouse and by a finger; each mistake that the grader knows has a line.
await page.goto(url('wrong.html'));
const pairs = page.locator('.pair'), slider = pairs.first().locator('input');
const clip = () => pairs.first().locator('img').nth(1).evaluate((image) => getComputedStyle(image).clipPath);
check('pairs of pictures', (await pairs.count()) >= 13, String(await pairs.count()));
const clips = () => pairs.first().locator('img').evaluateAll((images) => images.map((image) => getComputedStyle(image).clipPath));
check('half of each at first', (await clips()).every((half) => half.includes('50%')), (await clips()).join('; '));
await slider.focus();
await page.keyboard.press('End');
check('End shows the first alone', (await clip()).includes('100%'), await clip());
await page.keyboard.press('Home');
check('Home shows the second alone', /inset\(0(px)?( 0(px|%)?)*\)/.test(await clip()), await clip());
check('it says what is seen', /^0 % .+, 100 % .+/.test(await slider.getAttribute('aria-valuetext')), await slider.getAttribute('aria-valuetext'));
const track = await slider.boundingBox();
await page.mouse.click(track.x + track.width / 4, track.y + track.height / 2);
check('the mouse moves it', Math.abs(Number(await slider.inputValue()) - 25) < 5, await slider.inputValue());
const unequal = await pairs.evaluateAll((all) => all.filter((pair) => {
    const [first, second] = pair.querySelectorAll('img');
    return first.src === second.src || first.getAttribute('width') !== second.getAttribute('width');
}).length);
check('two pictures of one size each', unequal === 0, String(unequal));
const lab = (name) => name.slice(0, 2);
for (const name of readdirSync('solutions').filter((folder) => /^\d\d-/.test(folder))) {
    const names = JSON.parse(readFileSync(`solutions/${name}/mistakes.json`, 'utf8')).map((mistake) => mistake.name).sort();
    const lines = (await page.locator(`[id="${lab(name)}-mistakes"] li`).allTextContents()).sort();
    check(`lab ${lab(name)}: each mistake has its line`, JSON.stringify(names) === JSON.stringify(lines), `${lines.length} of ${names.length}`);
}
await page.goto(url('04-acne-and-bias.html'));
await page.getByRole('link', { name: /mistakes that the grader knows/ }).click();
const unfolds = await page.locator('[id="04-mistakes"] li').first().waitFor({ timeout: 10000 }).then(() => true, () => false);
check('the handout leads to the list, which unfolds', unfolds);
check('the handout has the pairs, too', (await (await open(browser, url('04-acne-and-bias.html'))).locator('.pair').count()) >= 2);

const phone = await browser.newContext({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }), small = await phone.newPage();
await small.goto(url('wrong.html'));
const tapped = small.locator('.pair input').first();
await tapped.scrollIntoViewIfNeeded();
const there = await tapped.boundingBox();
await small.touchscreen.tap(there.x + there.width - 12, there.y + there.height / 2);
check('a tap moves it', Number(await tapped.inputValue()) > 85, await tapped.inputValue());

// Without scripts, and on paper, both pictures are seen.
const whole = (sheet) => sheet.locator('.pair').first().locator('img').evaluateAll((images) => {
    const [a, b] = images.map((image) => image.getBoundingClientRect());
    return getComputedStyle(images[1]).clipPath === 'none' && (a.right <= b.left || a.bottom <= b.top);
});
const still = await (await browser.newContext({ javaScriptEnabled: false })).newPage();
await still.goto(url('wrong.html'));
check('without scripts both are seen, and no slider', (await whole(still)) && !(await still.locator('.pair input:visible').count()));
await page.goto(url('wrong.html'));
await page.emulateMedia({ media: 'print' });
check('on paper, too', (await whole(page)) && !(await page.locator('nav:visible').count()));
check('nothing went wrong', !page.misdeeds.length, page.misdeeds.join(' '));
await browser.close();
finish();
