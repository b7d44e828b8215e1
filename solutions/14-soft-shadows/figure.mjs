// The figure of lab 14: a lamp, one or two blockers that end somewhere, and the light that falls on the floor: in truth, and by a kernel.
import { clamp } from "../../grader/site/geometry.mjs";
import { fixed, percent } from "../../grader/site/numbers.mjs";

const HIGH = 4; // of the lamp above the floor
const blockers = ({ first, second, two }) => (two ? [first, second] : [first]);

// The share of the lamp that a point of the floor sees past blockers that reach from the left to `end`.
export function truth(state, x) {
  const { side } = state;
  return Math.min(...blockers(state).map(([end, h]) => clamp((side / 2 - x - ((end - x) * HIGH) / h) / side, 0, 1)));
}

// Half a kernel's width on the floor, for a blocker at the height h.
export const reach = (side, h) => (side * h) / (2 * (HIGH - h));

// What the search finds around x: the mean distance from the lamp; 0 where it finds nothing. In the map the higher one hides the other.
export function meanBlocker(state, x) {
  const half = reach(state.side, state.search), from = x - half, to = x + half;
  let found = 0, sum = 0, left = from;
  for (const [end, h] of [...blockers(state)].sort((a, b) => b[1] - a[1])) {
    const edge = clamp((end * HIGH) / (HIGH - h), left, to); // where its shadow ends on the floor
    found += edge - left;
    sum += (edge - left) * (HIGH - h);
    left = edge;
  }
  return found > 1e-9 ? sum / found : 0;
}

// The share of the kernel that is lit.
export function filtered(state, x) {
  const mean = meanBlocker(state, x);
  if (mean === 0) return 1;
  const half = Math.max(1e-6, reach(state.side, HIGH - mean)), edge = Math.max(...blockers(state).map(([end, h]) => (end * HIGH) / (HIGH - h)));
  return clamp((x + half - edge) / (2 * half), 0, 1);
}

function curve(s, light, kind) {
  for (let x = -3; x < 3; x += 0.05) s.line([x, -1.3 + light(x)], [x + 0.05, -1.3 + light(x + 0.05)], kind);
}

function draw(s, state) {
  const { side, point } = state, x = point[0];
  s.area([[-side / 2, HIGH], [side / 2, HIGH], [x, 0]], "half");
  s.line([-side / 2, HIGH], [side / 2, HIGH], "lamp");
  s.text([0, HIGH], "lamp", "n", "lamp");
  s.line([-3, 0], [3, 0], "surface");
  for (const [end, h] of blockers(state)) s.line([-3, h], [end, h], "surface");
  const mean = meanBlocker(state, x);
  if (mean > 0) {
    const half = (side * (HIGH - mean)) / HIGH / 2, middle = (x * mean) / HIGH;
    s.line([middle - half, HIGH - mean], [middle + half, HIGH - mean], "mark");
  }
  curve(s, (at) => truth(state, at), "line");
  curve(s, (at) => filtered(state, at), "mark");
  s.text([0, -1.65], "truth: thin; the kernel: thick", "c", "quiet");
}

function numbers(state) {
  const { side, first, point } = state, x = point[0], mean = meanBlocker(state, x), error = filtered(state, x) - truth(state, x);
  return [
    ["penumbra of the first blocker", fixed((side * first[1]) / (HIGH - first[1]), 2)],
    ["mean blocker", mean > 0 ? `${fixed(mean, 2)} from the lamp` : "none"],
    ["kernel there", mean > 0 ? fixed((side * (HIGH - mean)) / HIGH, 2) : "none"],
    ["light, in truth", percent(truth(state, x), 1)],
    ["light, by the kernel", percent(filtered(state, x), 1)],
    ["error", fixed(error, 3), Math.abs(error) > 0.05 ? "bad" : ""],
  ];
}

export const figure = {
  title: "Play: the lamp seen through a point.",
  about: "Drag the blockers' ends and the point of the floor. With one blocker the kernel is right; with two whose shadows end in one place it is not.",
  view: { width: 640, height: 420, unit: 62, origin: [320, 300], text: "A lamp, blockers, and the light on the floor" },
  knobs: {
    side: { label: "lamp", least: 0.1, most: 3, step: 0.05, value: 1.2 },
    search: { label: "search up to the height", least: 0.5, most: 3.5, step: 0.05, value: 3 },
    two: { label: "blockers", choices: ["one", "two"], value: 0 },
  },
  points: {
    first: { label: "first blocker", at: [-0.3, 2], box: [[-2.5, 0.2], [2.5, 3]], step: 0.05 },
    second: { label: "second blocker", at: [-0.5, 0.6], box: [[-2.5, 0.2], [2.5, 3]], step: 0.05, when: ({ two }) => two > 0 },
    point: { label: "point", at: [0.1, 0], box: [[-2.9, 0], [2.9, 0]], step: 0.05 },
  },
  draw, numbers,
};
