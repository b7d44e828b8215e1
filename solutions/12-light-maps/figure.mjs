// The figure of lab 12: a lamp over a face from x = 0 to x = 10, whose light is kept in luxels along one line.
import { clamp, range } from "../../grader/site/geometry.mjs";
import { fixed, percent } from "../../grader/site/numbers.mjs";

const NONE = 0, BLACK = 0, side = 10, plate = 1.2;
const size = ({ luxels }) => side / luxels;

// The light of a lamp of strength 1 on the face: cos / r², where no plate is in the way.
export function irradiance(x, { lamp, plates, board }) {
  const across = x - lamp[0], at = x - across * (board[1] / lamp[1]);
  if (plates !== NONE && Math.abs(at - board[0]) < plate / 2) return 0;
  return lamp[1] / (lamp[1] ** 2 + across ** 2) ** 1.5;
}

// A luxel: the light at its middle. Outside of the chart lies the padding: black, or the border's luxel again.
export function luxel(i, state) {
  if (state.padding === BLACK && (i < 0 || i >= state.luxels)) return 0;
  return irradiance((clamp(i, 0, state.luxels - 1) + 0.5) * size(state), state);
}

// What the linear filter makes of the luxels.
export function looked(x, state) {
  const place = x / size(state) - 0.5, i = Math.floor(place), f = place - i;
  return (1 - f) * luxel(i, state) + f * luxel(i + 1, state);
}

// The largest error between two places of the face, of many looked at.
export const worst = (from, to, state, n = 2000) => Math.max(...range(n).map((i) => from + ((to - from) * (i + 0.5)) / n).map((x) => Math.abs(looked(x, state) - irradiance(x, state))));

// Straight under the lamp along one line: at most this share of the light is wrong (half of the bound for a face).
export const bound = (state) => (3 * size(state) ** 2) / (8 * state.lamp[1] ** 2);

function draw(s, state) {
  const { lamp, board, luxels, plates } = state, one = size(state), up = s.panel({ origin: [20, 394], unit: 60 });
  const high = 2.1 / Math.max(...range(200).map((i) => irradiance((i + 0.5) / 20, state)), 0.01);
  s.line([0, 0], [side, 0], "surface");
  for (const i of range(luxels + 1)) s.line([i * one, 0], [i * one, -0.14], "line");
  if (plates !== NONE) s.line([board[0] - plate / 2, board[1]], [board[0] + plate / 2, board[1]], "surface");
  for (const i of range(luxels)) up.box([i * one, 0], [(i + 1) * one, high * luxel(i, state)], "half");
  const over = (what) => range(601).map((i) => (i * side) / 600).map((x) => [x, high * what(x, state)]);
  up.path(over(irradiance), "dashed");
  up.path(over(looked), "lamp");
  up.line([0, 0], [side, 0], "line");
  for (const x of [0, side]) s.line([x, 0], lamp, "beam");
  s.light(lamp, "");
}

function numbers(state) {
  const one = size(state), under = clamp(state.lamp[0], 2 * one, side - 2 * one), there = irradiance(state.lamp[0], { ...state, plates: NONE });
  const border = Math.max(worst(0, one / 2, state), worst(side - one / 2, side, state)), all = worst(0, side, state);
  return [
    ["luxel s", fixed(one, 3)],
    ["light straight under the lamp, 1 / h²", fixed(there, 3)],
    ["wrong by at most, under the lamp", percent(worst(under - one, under + one, state) / there, 2)],
    ["3 s² / (8 h²), along one line", percent(bound(state), 2)],
    ["at the face's borders", percent(border / there, 1), border > 0.1 * there ? "bad" : "good"],
    ["anywhere", percent(all / there, 1), all > 0.3 * there ? "bad" : ""],
  ];
}

export const figure = {
  title: "Play: light in luxels.",
  about: "Dashed is the light on the face, grey the luxels, orange what the filter makes of them. Drag the lamp and the plate; leave the padding black.",
  view: { width: 640, height: 410, unit: 60, origin: [20, 240], text: "A lamp over a face, and the light on the face in luxels" },
  knobs: {
    luxels: { label: "luxels", least: 4, most: 80, step: 1, value: 16, digits: 0 },
    padding: { label: "padding", choices: ["black", "filled"], value: BLACK },
    plates: { label: "plate", choices: ["none", "one"], value: NONE },
  },
  points: {
    lamp: { label: "lamp", at: [4, 2.6], box: [[0.5, 1.2], [9.5, 3.7]] },
    board: { label: "plate", when: ({ plates }) => plates !== NONE, at: [6, 1], box: [[0.6, 0.2], [9.4, 3.4]], keep: ([x, y], { lamp }) => [x, Math.min(y, lamp[1] - 0.3)] },
  },
  draw, numbers,
};
