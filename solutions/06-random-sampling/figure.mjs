// The figure of lab 06: the samples of one pixel in a disc of radius 1, at an edge or under a round caster.
import { clamp, random, range } from "../../grader/site/geometry.mjs";
import { fixed, percent } from "../../grader/site/numbers.mjs";

const EDGE = 0;

// Sample k in the unit square: `cells` columns and rows, moved by the jitter within its cell; the last row comes first.
export function inSquare(k, { columns, rows, jitter }, next) {
  const move = [next() - 0.5, next() - 0.5];
  return [((k % columns) + 0.5 + jitter * move[0]) / columns, (rows - 1 - Math.floor(k / columns) + 0.5 + jitter * move[1]) / rows];
}
export const inDisc = ([u, v]) => [Math.sqrt(v) * Math.cos(2 * Math.PI * u), Math.sqrt(v) * Math.sin(2 * Math.PI * u)];

export function samples(state) {
  const next = random(state.pattern);
  return range(state.columns * state.rows).map((k) => inDisc(inSquare(k, state, next)));
}

// Is a place of the disc lit? Right of the edge, or outside of the caster.
export const lit = ([x, y], { caster, kind, size }) => (kind === EDGE ? x > caster[0] : Math.hypot(x - caster[0], y - caster[1]) > size);

// The area that two circles have in common, of radius 1 and b, their middles d apart.
export function lens(b, d) {
  if (d >= 1 + b) return 0;
  if (d <= Math.abs(1 - b)) return Math.PI * Math.min(1, b) ** 2;
  const [p, q] = [(d * d + 1 - b * b) / 2 / d, (d * d + b * b - 1) / 2 / d];
  return Math.acos(clamp(p, -1, 1)) - p * Math.sqrt(Math.max(0, 1 - p * p)) + b * b * Math.acos(clamp(q / b, -1, 1)) - q * Math.sqrt(Math.max(0, b * b - q * q));
}

// The share of the disc that is lit, exactly.
export function truth({ caster, kind, size }) {
  const t = clamp(-caster[0], -1, 1);
  return kind === EDGE ? 0.5 + (t * Math.sqrt(1 - t * t) + Math.asin(t)) / Math.PI : 1 - lens(size, Math.hypot(...caster)) / Math.PI;
}

// What the pixel gets: all samples, or only eight where the eight agree.
export function visibility(state) {
  const answers = samples(state).map((sample) => lit(sample, state)), mean = (list) => list.filter(Boolean).length / list.length;
  const first = mean(answers.slice(0, 8)), agree = state.early === 1 && (first === 0 || first === 1);
  return { first, used: agree ? Math.min(8, answers.length) : answers.length, value: agree ? first : mean(answers) };
}

function draw(s, state) {
  const { caster, kind, size } = state, all = samples(state);
  const right = s.panel({ origin: [s.place([0, 0])[0], s.place([0, 0])[1]], unit: s.unit }), left = s.panel({ origin: [30, 262], unit: 224 });
  for (const i of range(state.columns + 1)) left.line([i / state.columns, 0], [i / state.columns, 1], "faint");
  for (const i of range(state.rows + 1)) left.line([0, i / state.rows], [1, i / state.rows], "faint");
  const next = random(state.pattern), look = (k, point) => (lit(point, state) ? "lamp" : "");
  all.forEach((sample, k) => left.dot(inSquare(k, state, next), look(k, sample), k < 8 ? 6 : 3.5));
  left.text([0.5, 0], "square", "s");
  right.circle([0, 0], 1, "line");
  if (kind === EDGE) {
    right.line([caster[0], -1.12], [caster[0], 1.12], "line");
    const turn = Math.acos(clamp(caster[0], -1, 1)); // what is left of the edge is dark
    right.area(range(65).map((i) => turn + (i / 64) * 2 * (Math.PI - turn)).map((a) => [Math.cos(a), Math.sin(a)]), "half");
  } else {
    right.circle(caster, size, "half");
    right.circle(caster, size, "line");
  }
  for (const row of range(state.rows)) right.circle([0, 0], Math.sqrt((row + 1) / state.rows), "faint");
  all.forEach((sample, k) => right.dot(sample, look(k, sample), k < 8 ? 6 : 3.5));
  right.text([0, -1.1], "disc", "s");
}

function numbers(state) {
  const found = visibility(state), exact = truth(state), error = found.value - exact;
  return [
    ["true share of light", percent(exact, 1)],
    ["the first eight say", percent(found.first, 1)],
    ["samples taken", `${found.used} of ${state.columns * state.rows}`],
    ["the pixel gets", percent(found.value, 1)],
    ["error", fixed(error, 3), Math.abs(error) > 0.15 ? "bad" : ""],
    ["one sample weighs", fixed(1 / found.used, 3)],
  ];
}

export const figure = {
  title: "Play: a pixel's samples.",
  about: "Large dots are the first eight. Drag the edge, or the round caster: a small one in the middle is missed by all eight. Another pattern is another pixel.",
  view: { width: 640, height: 300, unit: 116, origin: [464, 142], text: "Samples in a square and in a disc under a caster" },
  knobs: {
    kind: { label: "caster", choices: ["a straight edge", "round"], value: 1 },
    size: { label: "its radius", least: 0.1, most: 1.5, step: 0.01, value: 0.6, when: ({ kind }) => kind !== EDGE },
    early: { label: "early-out", choices: ["off", "on"], value: 1 },
    columns: { label: "columns", least: 2, most: 8, step: 1, value: 4, digits: 0 },
    rows: { label: "rows", least: 4, most: 12, step: 1, value: 8, digits: 0 },
    jitter: { label: "jitter", least: 0, most: 1, step: 0.05, value: 1 },
    pattern: { label: "pattern", least: 1, most: 64, step: 1, value: 6, digits: 0 },
  },
  points: { caster: { label: "caster", at: [0.1, 0.05], box: [[-1.3, -1.1], [1.3, 1.1]], step: 0.05 } },
  draw, numbers,
};
