// course.mjs SITE: the site as a student uses it: the first page, the list of pages on a narrow screen, the search, an answer.
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
await page.locator('#q').fill('');
check('an empty question', !(await hits()).length);
await page.locator('#q').fill('acne');
await page.locator('#found a').first().click();
check('a hit leads to its section', /\.html(#|$)/.test(page.url()) && !page.misdeeds.length, page.url());

// The answer is there, folded up, and not found by the search.
await page.goto(url('03-shadow-map.html'));
const answer = page.locator('details.answer');
check('the answer is folded up', !(await answer.locator('p').first().isVisible()));
await answer.locator('summary').focus();
await page.keyboard.press('Enter');
check('a key unfolds it', await answer.locator('p').first().isVisible());
check('a slide stands at a task', (await page.locator('.chips li', { hasText: '000 10.3' }).count()) > 0);
const words = (await answer.locator('p').first().textContent()).split(' ').slice(0, 12).join(' ');
await page.goto(`${url('search.html')}?q=${encodeURIComponent(words)}`);
check('no answer is found', (await hits()).length === 0, words);
await browser.close();
finish();
