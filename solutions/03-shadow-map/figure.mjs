// The figure of lab 03: a lamp that looks straight down, a board, a floor at y = 0, and the map between them.
import { fall, range } from "../../grader/site/geometry.mjs";
import { fixed } from "../../grader/site/numbers.mjs";

const near = 0.5, far = 7, slope = 0.9, width = 1.3; // the map shows `slope` to either side, at distance 1

// The depth in [0, 1] of what lies `d` before the lamp.
export const depth = (d) => ((far + near) / (far - near) - (2 * far * near) / ((far - near) * d) + 1) / 2;

// What a texel of the map keeps: how far before the lamp the nearest surface is on the ray through its middle.
export function kept(i, { lamp, board, texels }) {
  const at = lamp[0] + slope * ((2 * (i + 0.5)) / texels - 1) * (lamp[1] - board[1]);
  return Math.abs(at - board[0]) <= width / 2 ? lamp[1] - board[1] : lamp[1];
}

// The texel of a place x on the floor; none outside of the map.
export function texel(x, { lamp, texels }) {
  const place = ((x - lamp[0]) / (lamp[1] * slope) + 1) / 2;
  return place >= 0 && place < 1 ? Math.floor(place * texels) : undefined;
}

// The shadow on the floor from a to b: as it is, and as the map has it; undefined where the map has none.
export function shadows(state) {
  const { lamp, board, texels } = state;
  const truth = [-1, 1].map((side) => fall(lamp, [board[0] + (side * width) / 2, board[1]])[0]);
  const dark = range(texels).filter((i) => kept(i, state) < lamp[1]);
  const border = (i) => lamp[0] + slope * lamp[1] * ((2 * i) / texels - 1);
  return { truth, map: dark.length ? [border(dark[0]), border(dark.at(-1) + 1)] : undefined, size: (2 * slope * lamp[1]) / texels };
}

// The length of floor on which the two differ.
export function wrong({ truth: [a, b], map }) {
  if (!map || map[1] <= a || map[0] >= b) return b - a + (map ? map[1] - map[0] : 0);
  return Math.abs(a - map[0]) + Math.abs(b - map[1]);
}

function draw(s, state) {
  const { lamp, board, point, texels } = state, { truth, map } = shadows(state);
  for (const i of range(texels + 1)) s.line(lamp, [lamp[0] + slope * lamp[1] * ((2 * i) / texels - 1), 0], "faint");
  const ends = [-1, 1].map((side) => [board[0] + (side * width) / 2, board[1]]);
  s.area([...ends, [truth[1], 0], [truth[0], 0]], "half");
  s.line([-5, 0], [5, 0], "surface");
  const piece = (from, to, kind) => from < to && s.line([from, 0], [to, 0], kind), [a, b] = truth, [c, d] = map ?? [b, b];
  piece(c, Math.min(d, a), "blue");
  piece(Math.max(c, b), d, "blue");
  piece(a, Math.min(b, c), "yellow");
  piece(Math.max(a, d), b, "yellow");
  piece(Math.max(a, c), Math.min(b, d), "shade");
  s.line(...ends, "surface");
  for (const i of range(texels)) {
    const d = kept(i, state), at = [lamp[0] + slope * ((2 * (i + 0.5)) / texels - 1) * d, lamp[1] - d];
    s.dot(at, "lamp", 3);
  }
  s.line(lamp, point, "eye");
  s.dot(point, "eye", 6);
  s.light(lamp, "", "e");
  s.text(point, "point", "s", "eye", 6);
}

function numbers(state) {
  const { lamp, point } = state, both = shadows(state), i = texel(point[0], state), size = wrong(both);
  const map = i === undefined ? undefined : kept(i, state), dark = map < lamp[1];
  return [
    ["the point's depth", fixed(depth(lamp[1]), 3)],
    ["depth kept in its texel", map === undefined ? "outside of the map" : fixed(depth(map), 3)],
    ["so the point is", dark ? "in shadow" : "lit"],
    ["true shadow, a H / (H − h)", `${fixed(both.truth[1] - both.truth[0])} wide`],
    ["shadow by the map", both.map ? `${fixed(both.map[1] - both.map[0])} wide` : "none"],
    ["wrong on the floor", `${fixed(size)}: ${fixed(size / both.size, 1)} texels`, size > both.size ? "bad" : ""],
  ];
}

export const figure = {
  title: "Play: a map of few texels.",
  about: "Each orange dot is the nearest surface that one texel of the map keeps. Drag lamp, board and point. Blue is false shadow, yellow false light.",
  view: { width: 640, height: 330, unit: 62, origin: [320, 292], text: "A lamp over a board over a floor, from the side" },
  knobs: { texels: { label: "texels", least: 3, most: 64, step: 1, value: 16, digits: 0 } },
  points: {
    lamp: { label: "lamp", at: [-0.6, 4.2], box: [[-3, 2.5], [3, 4.4]] },
    board: { label: "board", at: [0.1, 1.8], box: [[-3, 0.3], [3, 3.4]], keep: ([x, y], { lamp }) => [x, Math.min(y, lamp[1] - 0.6)] },
    point: { label: "point on the floor", at: [1.1, 0], box: [[-4.8, 0], [4.8, 0]] },
  },
  draw, numbers,
};
