// The figure of lab 05: texels of side 1, the straight edge of a shadow through `edge` (what is left of it is dark), and
// a box of taps around `point`.
import { clamp, radians, range } from "../../grader/site/geometry.mjs";
import { fixed } from "../../grader/site/numbers.mjs";

const NEAREST = 0, columns = 13, rows = 6;

// Is a place lit? In the map it is asked at the middle of a texel.
export const truth = ([x, y], { edge, angle }) => (x - edge[0]) * Math.cos(radians(angle)) + (y - edge[1]) * Math.sin(radians(angle)) >= 0;
export const texelLit = (i, j, state) => Number(truth([i + 0.5, j + 0.5], state));

// One tap: the answer of a texel, or four answers blended.
export function tap([x, y], state) {
  if (state.filter === NEAREST) return texelLit(Math.floor(x), Math.floor(y), state);
  const [u, v] = [x - 0.5, y - 0.5], [i, j] = [Math.floor(u), Math.floor(v)], [f, g] = [u - i, v - j];
  return (1 - g) * ((1 - f) * texelLit(i, j, state) + f * texelLit(i + 1, j, state)) + g * ((1 - f) * texelLit(i, j + 1, state) + f * texelLit(i + 1, j + 1, state));
}

export const taps = ([x, y], { radius }) => range((2 * radius + 1) ** 2).map((k) => [x + (k % (2 * radius + 1)) - radius, y + Math.floor(k / (2 * radius + 1)) - radius]);

export function visibility(point, state) {
  const all = taps(point, state);
  return all.reduce((sum, at) => sum + tap(at, state), 0) / all.length;
}

// Over the row of texels with the place y, at n places a texel and a third as many heights: the mean of |V - truth| times the
// length, so how wide a strip is wrong; and how wide the ramp is. Both are measured across the edge.
export function row(y, state, n = 24) {
  const across = Math.cos(radians(state.angle)), reach = 6 + 2 * state.radius, heights = range(n / 3).map((j) => Math.floor(y) + (j + 0.5) / (n / 3));
  let error = 0, ramp = 0;
  for (const height of heights) {
    const middle = state.edge[0] - (height - state.edge[1]) * Math.tan(radians(state.angle));
    for (const place of range(2 * reach * n).map((i) => [middle - reach + (i + 0.5) / n, height])) {
      const v = visibility(place, state);
      error += Math.abs(v - truth(place, state));
      ramp += v > 1e-9 && v < 1 - 1e-9;
    }
  }
  return { error: (error * across) / n / heights.length, ramp: (ramp * across) / n / heights.length };
}

// How many texels away the farthest place lies that a comparison is about: so much the bias must reach.
export const reach = ({ radius, filter }) => radius + (filter === NEAREST ? 0.5 : 1);

function draw(s, state) {
  const { point, edge, angle } = state;
  for (const i of range(columns)) for (const j of range(rows)) if (!texelLit(i, j, state)) s.box([i, j], [i + 1, j + 1], "half");
  for (const i of range(columns + 1)) s.line([i, 0], [i, rows], "faint");
  for (const j of range(rows + 1)) s.line([0, j], [columns, j], "faint");
  const on = (y) => [edge[0] - (y - edge[1]) * Math.tan(radians(angle)), y];
  s.line(on(0), on(rows), "line");
  for (const at of taps(point, state)) s.dot(at, tap(at, state) > 0.5 ? "lamp" : "", 4);
  // Below: V along the row of the point.
  const base = -2.6, high = 1.8, at = ([x, v]) => [x, base + high * v], across = on(point[1])[0];
  s.line([0, base], [columns, base], "faint");
  s.path([[0, 0], [clamp(across, 0, columns), 0], [clamp(across, 0, columns), 1], [columns, 1]].map(at), "dashed");
  s.path(range(columns * 12 + 1).map((i) => at([i / 12, visibility([i / 12, point[1]], state)])), "lamp");
  s.line([point[0], base], at([point[0], 1]), "faint");
  s.dot(at([point[0], visibility(point, state)]), "mark");
  s.text([0, base + high], "V", "w");
}

function numbers(state) {
  const { error, ramp } = row(state.point[1], state), n = (2 * state.radius + 1) ** 2;
  return [
    ["V at the point", fixed(visibility(state.point, state), 3)],
    ["lookups", String(n)],
    ["ramp across the edge", `${fixed(ramp, 1)} texels`],
    ["wrong along the edge", `${fixed(error, 2)} texels`],
    ["the bias reaches r", `${fixed(reach(state), 1)} texels`],
  ];
}

export const figure = {
  title: "Play: a kernel at an edge.",
  about: "Grey texels are dark in the map. Drag the point with its taps, and the edge. Below is V along the row of the point; dashed is the truth.",
  view: { width: 640, height: 424, unit: 46, origin: [24, 288], text: "Texels with the edge of a shadow, and the share of light along a row" },
  knobs: {
    radius: { label: "radius k", least: 0, most: 3, step: 1, value: 1, digits: 0 },
    filter: { label: "a tap is", choices: ["one texel", "four, blended"], value: 1 },
    angle: { label: "edge turned", least: 0, most: 60, step: 1, value: 0, digits: 0, unit: "°" },
  },
  points: {
    point: { label: "point", at: [6.6, 3.4], box: [[0.5, 0.5], [12.5, 5.5]] },
    edge: { label: "edge", at: [6, 1], box: [[3, 0.5], [10, 5.5]] },
  },
  draw, numbers,
};
