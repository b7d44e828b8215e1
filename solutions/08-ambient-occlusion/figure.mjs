// The figure of lab 08: a point on the floor, at the distance x before an endless wall of the height h, and rays from it.
import { random, range } from "../../grader/site/geometry.mjs";
import { fixed } from "../../grader/site/numbers.mjs";

const COSINE = 0, foot = 3.2; // where the wall stands
const measures = ({ point, top }) => ({ x: foot - point[0], h: top[1] });

// Pairs of numbers in [0, 1): one in each of side x side cells, in its middle or anywhere.
export function pairs({ side, spread, pattern }) {
  const next = random(pattern);
  return range(side * side).map((i) => {
    const [a, b] = [next(), next()];
    return spread === 0 ? [a, b] : [((i % side) + a) / side, (Math.floor(i / side) + b) / side];
  });
}

// A direction [to the wall, along it, up]: more of them near the normal, or evenly over the hemisphere.
export function direction([u, v], weight) {
  const up = weight === COSINE ? Math.sqrt(1 - u) : 1 - u, r = Math.sqrt(1 - up * up);
  return [r * Math.cos(2 * Math.PI * v), r * Math.sin(2 * Math.PI * v), up];
}

export const hits = ([across, , up], { x, h }) => across > 0 && up * x < h * across;
export const formula = ({ x, h }, weight) => (weight === COSINE ? (1 - x / Math.hypot(x, h)) / 2 : Math.atan(h / x) / Math.PI);

export function occlusion(state) {
  const all = pairs(state).map((pair) => direction(pair, state.weight));
  return all.filter((way) => hits(way, measures(state))).length / all.length;
}

function draw(s, state) {
  const { point, top, weight } = state, { x, h } = measures(state), all = pairs(state).map((pair) => direction(pair, weight));
  s.line([-0.2, 0], [5, 0], "surface");
  s.line([foot, 0], top, "surface");
  s.path(range(65).map((i) => [point[0] + Math.cos((i * Math.PI) / 64), Math.sin((i * Math.PI) / 64)]), "dashed");
  for (const way of all) {
    const [across, , up] = way, hit = hits(way, { x, h }), long = hit ? x / across : 1;
    s.line(point, [point[0] + across * long, up * long], hit ? "mark" : "beam");
  }
  s.dot(point, "eye", 6);
  const disc = s.panel({ origin: [514, 130], unit: 108 }), narrow = x / Math.hypot(x, h);
  disc.circle([0, 0], 1, "line");
  const rim = range(33).map((i) => (i / 32 - 0.5) * Math.PI);
  disc.area([...rim.map((a) => [Math.cos(a), Math.sin(a)]), ...rim.reverse().map((a) => [narrow * Math.cos(a), Math.sin(a)])], "half");
  for (const way of all) disc.dot([way[0], way[1]], hits(way, { x, h }) ? "mark" : "lamp", all.length > 150 ? 2.5 : 4);
  disc.text([0, -1.05], "from above: grey is the wall", "s", "small");
}

function numbers(state) {
  const all = measures(state), found = occlusion(state), right = formula(all, COSINE), n = state.side ** 2;
  return [
    ["hits / rays", `${Math.round(found * n)} / ${n} = ${fixed(found, 3)}`],
    ["(1 − x / √(x² + h²)) / 2", fixed(right, 3)],
    ["error", fixed(found - right, 3), Math.abs(found - right) > 0.05 ? "bad" : "good"],
    ["expected, √(A (1 − A) / N)", `about ${fixed(Math.sqrt((right * (1 - right)) / n), 3)}`],
    ["these rays tend to", `${fixed(formula(all, state.weight), 3)}`, state.weight === COSINE ? "" : "bad"],
    ["x, h", `${fixed(all.x)}, ${fixed(all.h)}`],
  ];
}

export const figure = {
  title: "Play: rays before a wall.",
  about: "Drag the point and the wall's top. Rays that hit are red. With rays spread evenly over the hemisphere, no number of them gives the right share.",
  view: { width: 640, height: 280, unit: 78, origin: [16, 244], text: "A point before a wall, with rays over its hemisphere, from the side and from above" },
  knobs: {
    side: { label: "rays, n × n", least: 1, most: 20, step: 1, value: 6, digits: 0 },
    weight: { label: "more rays", choices: ["where the cosine is larger", "nowhere: evenly"], value: COSINE },
    spread: { label: "pairs", choices: ["anywhere", "one in each cell"], value: 1 },
    pattern: { label: "pattern", least: 1, most: 64, step: 1, value: 8, digits: 0 },
  },
  points: {
    point: { label: "point on the floor", at: [2, 0], box: [[1, 0], [3.1, 0]], step: 0.05 },
    top: { label: "top of the wall", at: [foot, 1.6], box: [[foot, 0.1], [foot, 2.9]] },
  },
  draw, numbers,
};
