// What the browser tests share: a Chromium that counts what a page must not do, and a place for results.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { chromium } from 'playwright-core';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
let passed = 0, failed = 0;

/** Counts a check; `detail` is printed when it fails. */
export function check(name, ok, detail = '') {
    if (ok) passed++;
    else {
        failed++;
        console.log(`FAILED: ${name}${detail ? `\n    ${detail}` : ''}`);
    }
}

/** Prints the counts and sets the exit status. */
export function finish() {
    console.log(`${passed} passed, ${failed} failed`);
    process.exitCode = failed ? 1 : 0;
}

/** Starts the system's Chromium ($CHROMIUM). */
export function launch() {
    return chromium.launch({
        executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
        args: ['--headless', '--no-sandbox', '--disable-gpu', '--no-first-run', '--disable-background-networking',
            '--disable-component-update', '--disable-sync'],
    });
}

/**
 * Opens a page in a window of its own. `page.misdeeds` lists what a page must not do: errors on the console, exceptions, dialogs,
 * requests for anything but files and data.
 */
export async function open(browser, url, { width = 1200, height = 900, dark = false } = {}) {
    const context = await browser.newContext({ viewport: { width, height }, colorScheme: dark ? 'dark' : 'light' });
    const page = await context.newPage();
    page.misdeeds = [];
    page.on('console', (message) => message.type() === 'error' && page.misdeeds.push(`console: ${message.text()}`));
    page.on('pageerror', (error) => page.misdeeds.push(`exception: ${error.message}`));
    page.on('dialog', (dialog) => { page.misdeeds.push(`dialog: ${dialog.message()}`); dialog.dismiss(); });
    page.on('request', (request) => /^(file|data):/.test(request.url()) || page.misdeeds.push(`request: ${request.url()}`));
    await page.goto(url);
    return page;
}

/** The violations that axe-core finds with its `options`, one a line; "" when there are none. */
export async function violations(page, options = {}) {
    if (!(await page.evaluate(() => 'axe' in globalThis))) await page.evaluate(axe); // not a script element: the page's policy may forbid it
    const { violations: found } = await page.evaluate((rules) => globalThis.axe.run(rules), options);
    return found.map((rule) => `${rule.id}: ${rule.help}: ${rule.nodes[0].html.slice(0, 200)}`).join('\n    ');
}

/** Checks that a page misbehaves in no colours and at no width; `ready` waits until it is drawn. */
export async function behaves(browser, url, title, ready = () => {}) {
    for (const look of [{}, { dark: true }, { width: 360, height: 700 }]) {
        const page = await open(browser, url, look);
        await ready(page);
        const name = `${title} ${JSON.stringify(look)}`;
        check(`${name}: no error, dialog or request`, page.misdeeds.length === 0, page.misdeeds.join('\n    '));
        const found = await violations(page);
        check(`${name}: axe-core`, found === '', found);
        const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        check(`${name}: no scrolling sideways`, overflow <= 0, `${overflow} pixels too wide`);
        await page.context().close();
    }
}
