// Checks of a figure's numbers, counted, and the random numbers that they begin with: `figure_models.mjs [SEED]`.
import { random } from '../../site/geometry.mjs';

const seed = Number(process.argv[2] ?? Date.now() % 100000);
export const next = random(seed);
export const between = (least, most) => least + (most - least) * next();
export const times = (n, what) => Array.from({ length: n }, (_, i) => what(i));
export const counts = { passed: 0, failed: 0 };

export function near(name, found, expected, tolerance = 1e-9) {
    if (Math.abs(found - expected) <= tolerance) counts.passed++;
    else {
        counts.failed++;
        console.log(`FAILED: ${name}: ${found}, not ${expected} (seed ${seed})`);
    }
}
export const equal = (name, found, expected) => near(name, Number(found === expected), 1) || (found !== expected && console.log(`    found ${found}, expected ${expected}`));
// The greatest of many differences: one check for all of them.
export const all = (name, n, difference, tolerance = 1e-9) => near(`${name}, ${n} times`, Math.max(...times(n, difference).map(Math.abs)), 0, tolerance);
