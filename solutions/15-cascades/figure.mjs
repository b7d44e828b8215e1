// The figure of lab 15: the view from the side, cut into slices, with their spheres; how large a texel is beside a pixel.
import { range } from "../../grader/site/geometry.mjs";
import { fixed } from "../../grader/site/numbers.mjs";

const near = 0.5;

// Where the slices end: the near plane first, the far plane last.
export const borders = ({ lambda, count, far: [far] }) =>
  range(count + 1).map((i) => lambda * near * (far / near) ** (i / count) + (1 - lambda) * (near + ((far - near) * i) / count));

// Centre and radius of the smallest sphere around what lies between a and b, k to either side for each unit.
export function sphere(a, b, k) {
  const center = Math.min(((a + b) * (1 + k * k)) / 2, b);
  return [center, Math.hypot(b - center, b * k)];
}

// How many pixels wide a texel is, at the begin and at the end of slice i: as many texels along a map as pixels along the picture.
export function coarse(state, i) {
  const ends = borders(state), [, radius] = sphere(ends[i], ends[i + 1], state.k);
  return [ends[i], ends[i + 1]].map((distance) => radius / (distance * state.k));
}

// The same for the worst place of all.
export const worst = (state) => Math.max(...range(state.count).flatMap((i) => coarse(state, i)));

function draw(s, state) {
  const { k, far: [far] } = state, ends = borders(state);
  s.line([0, 0], [far, 0], "faint");
  s.line([0, 0], [far, far * k], "line");
  s.line([0, 0], [far, -far * k], "line");
  for (const end of ends) s.line([end, end * k], [end, -end * k], "line");
  for (const i of range(state.count)) {
    const [center, radius] = sphere(ends[i], ends[i + 1], k);
    s.circle([center, 0], radius, "mark");
    s.dot([center, 0], "mark", 3);
  }
  s.dot([0, 0], "eye", 5);
  s.text([0, 0], "eye", "s", "eye");
}

function numbers(state) {
  const slices = range(state.count).map((i) => {
    const [begin, end] = coarse(state, i);
    return [`slice ${i}: a texel in pixels`, `${fixed(begin, 1)} to ${fixed(end, 1)}`, begin > 6 ? "bad" : ""];
  });
  return [["borders", borders(state).map((end) => fixed(end, 1)).join(", ")], ...slices, ["the worst", fixed(worst(state), 1)]];
}

export const figure = {
  title: "Play: where to cut.",
  about: "Change lambda and the number of slices: the worst texel is the best with lambda at 1. Drag the far plane away, and see what one map would cost.",
  view: { width: 640, height: 400, unit: 50, origin: [40, 200], text: "The view in slices, with a sphere around each" },
  knobs: {
    count: { label: "slices", least: 1, most: 4, step: 1, value: 3 },
    lambda: { label: "lambda", least: 0, most: 1, step: 0.05, value: 0.7 },
    k: { label: "tangent of the corner", least: 0.15, most: 0.45, step: 0.01, value: 0.3 },
  },
  points: { far: { label: "far plane", at: [7, 0], box: [[2, 0], [8, 0]], step: 0.1 } },
  draw, numbers,
};
