// The figure of lab 10: a board pressed flat onto a plane through the origin, by a lamp that may be wide, or by a sun. Points
// have a third coordinate w, which is 0 for a sun.
import { add, clamp, radians, range, scale } from "../../grader/site/geometry.mjs";
import { fixed } from "../../grader/site/numbers.mjs";

const LAMP = 0, SUN = 1;
const dot3 = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export const plane = ({ tilt }) => [-Math.sin(radians(tilt)), Math.cos(radians(tilt)), 0];
export const lightPoint = ({ kind, lamp }) => (kind === SUN ? [lamp[0] - 4, lamp[1], 0] : [...lamp, 1]); // a sun shines from the lamp to (4, 0)

// The matrix (P.L) I - L P^T, by rows, and a point through it.
export function flattening(p, l) {
  return range(3).map((i) => range(3).map((j) => (i === j ? dot3(p, l) : 0) - l[i] * p[j]));
}
export function flattened(point, state, light = lightPoint(state)) {
  const [x, y, w] = flattening(plane(state), light).map((row) => dot3(row, [...point, 1]));
  return { at: [x / w, y / w], w };
}

// The lamps at equal distances in a wide one, each in the middle of its cell.
export const lamps = ({ lamp, side, count }) => range(count).map((i) => [lamp[0] + side * ((i + 0.5) / count - 0.5), lamp[1], 1]);

// Along the plane: where the shadows of the board's two ends lie, seen from the lamp's two ends.
export function borders(state) {
  const along = [Math.cos(radians(state.tilt)), Math.sin(radians(state.tilt))];
  const from = [-0.5, 0.5].map((i) => [state.lamp[0] + i * state.side, state.lamp[1], 1]);
  return [state.left, state.right].map((end) => from.map((light) => {
    const { at } = flattened(end, state, light);
    return at[0] * along[0] + at[1] * along[1];
  }));
}

// The share of the lamp that a place on the plane sees: of the whole lamp, and of the small lamps.
export function seen(t, state) {
  const place = scale([Math.cos(radians(state.tilt)), Math.sin(radians(state.tilt))], t), { lamp, side, left, right, count } = state;
  const cover = [left, right].map((end) => place[0] + ((end[0] - place[0]) * (lamp[1] - place[1])) / (end[1] - place[1])).sort((a, b) => a - b);
  const inside = (x) => clamp((x - lamp[0]) / side + 0.5, 0, 1), hidden = inside(cover[1]) - inside(cover[0]);
  return { whole: 1 - hidden, small: 1 - lamps(state).filter(([x]) => x > cover[0] && x < cover[1]).length / count };
}

export function worst(state, n = 2000) {
  const all = borders(state).flat(), low = Math.min(...all), high = Math.max(...all);
  return Math.max(...range(n).map((i) => seen(low + ((high - low) * (i + 0.5)) / n, state)).map(({ whole, small }) => Math.abs(whole - small)));
}

function draw(s, state) {
  const { kind, lamp, left, right, tilt, side } = state, way = [Math.cos(radians(tilt)), Math.sin(radians(tilt))];
  s.line(scale(way, -7), scale(way, 8), "surface");
  const sources = kind === SUN ? [lightPoint(state)] : lamps(state);
  for (const light of sources) {
    const [a, b] = [left, right].map((end) => flattened(end, state, light));
    const p = plane(state), under = Math.min(dot3(p, [...left, 1]), dot3(p, [...right, 1])) <= 0;
    if (under || a.w <= 0 || b.w <= 0) continue;
    s.area([left, right, b.at, a.at], "half");
    for (const [end, { at }] of [[left, a], [right, b]]) s.line(kind === SUN ? add(end, scale(light.slice(0, 2), 3)) : light.slice(0, 2), at, "lamp");
    s.line(a.at, b.at, "shade");
  }
  s.line(left, right, "surface");
  if (kind === LAMP && side > 0) s.line([lamp[0] - side / 2, lamp[1]], [lamp[0] + side / 2, lamp[1]], "yellow");
  s.light(lamp, "", "e");
}

function numbers(state) {
  const p = plane(state), light = lightPoint(state), height = dot3(p, light), low = dot3(p, [...state.left, 1]), { at, w } = flattened(state.left, state);
  const shadow = low <= 0 ? "none: under the plane" : w <= 0 ? "none: over the lamp" : `(${fixed(at[0])}, ${fixed(at[1])})`;
  const rows = [["P · L", fixed(height)], ["P · v, of the board's left end", fixed(low)], ["w′", fixed(w), w <= 0 ? "bad" : ""], ["v′ / w′", shadow, low <= 0 || w <= 0 ? "bad" : ""]];
  if (state.kind === SUN || low <= 0 || w <= 0) return rows;
  const [[a, b]] = borders(state), level = state.tilt === 0;
  rows.push(["penumbra, drawn", fixed(Math.abs(b - a))]);
  if (level) rows.push(["penumbra, s h / (H − h)", fixed((state.side * low) / (height - low))]);
  if (state.side > 0) rows.push(["levels of light", String(state.count + 1)], ["worst error", fixed(worst(state), 3)], ["at most 1 / (2n)", fixed(1 / (2 * state.count), 3)]);
  return rows;
}

export const figure = {
  title: "Play: press it flat.",
  about: "Drag the lamp, and the board by its ends: under the plane, over the lamp. A wide lamp is cut into small ones.",
  view: { width: 640, height: 330, unit: 52, origin: [230, 270], text: "A lamp over a board over a plane, from the side" },
  knobs: {
    kind: { label: "light", choices: ["lamp", "sun"], value: LAMP },
    tilt: { label: "plane turned", least: -15, most: 15, step: 1, value: 0, digits: 0, unit: "°" },
    side: { label: "its side s", least: 0, most: 2, step: 0.05, value: 1, when: ({ kind }) => kind === LAMP },
    count: { label: "small lamps n", least: 1, most: 12, step: 1, value: 4, digits: 0, when: ({ kind }) => kind === LAMP },
  },
  points: {
    lamp: { label: "lamp", at: [0, 4.6], box: [[-4, 2.5], [4, 4.9]] },
    left: { label: "left end of the board", at: [0.4, 2], box: [[-3.8, -0.8], [7, 4.8]] },
    right: { label: "right end of the board", at: [2, 2], box: [[-3.8, -0.8], [7, 4.8]] },
  },
  draw, numbers,
};
