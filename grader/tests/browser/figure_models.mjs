// figure_models.mjs [SEED]: are the numbers of the site's figures right, and has every state some? Needs no browser.
import { readdirSync } from 'node:fs';
import { settle, start } from '../../site/play.mjs';
import { sketch } from '../../site/sketch.mjs';
import { between, counts, equal, next, times } from './figure_checks.mjs';
import { models } from './figure_forms.mjs';

const root = new URL('../../../solutions/', import.meta.url);
const lab = (id) => import(new URL(`${readdirSync(root).find((name) => name.startsWith(id))}/figure.mjs`, root));

// At any state, the extremes too, a figure has numbers and draws with them.
function broken(figure) {
    const pick = (least, most) => [least, most, between(least, most)][Math.floor(between(0, 3))], state = start(figure);
    for (const [name, { choices, least, most, step }] of Object.entries(figure.knobs))
        state[name] = choices ? Math.floor(between(0, choices.length)) : Math.round(pick(least, most) / step) * step;
    for (const [name, { box: [[x, y], [u, v]], keep = (at) => at }] of [...Object.entries(figure.points), ...Object.entries(figure.points)])
        state[name] = keep([pick(x, u), pick(y, v)], state);
    const drawing = sketch(figure.view);
    figure.draw(drawing, state);
    return [...drawing.parts, ...figure.numbers(state).flat()].some((text) => /NaN|undefined|Infinity/.test(text));
}

// Whichever point moves, all of them are where the figure wants them.
function unsettled(figure) {
    const state = start(figure);
    for (const [name, { box: [[x, y], [u, v]] }] of Object.entries(figure.points).sort(() => next() - 0.5)) {
        state[name] = [between(x, u), between(y, v)];
        settle(figure, state);
    }
    return Object.entries(figure.points).some(([name, { keep = (at) => at }]) => Math.hypot(...keep(state[name], state).map((x, i) => x - state[name][i])) > 1e-9);
}

for (const id of Object.keys(models)) {
    const { figure } = await lab(id);
    equal(`${id}: all points are where they may be`, times(60, () => unsettled(figure)).filter(Boolean).length, 0);
    equal(`${id}: no state is without numbers`, times(60, () => broken(figure)).filter(Boolean).length, 0);
}
for (const [id, test] of Object.entries(models)) await test(await lab(id));
const untested = readdirSync(root).filter((name) => /^\d\d-/.test(name) && !models[name.slice(0, 2)]);
equal('each lab\'s figure is tested here', untested.join(' '), '');
console.log(`${counts.passed} passed, ${counts.failed} failed`);
process.exitCode = counts.failed ? 1 : 0;
