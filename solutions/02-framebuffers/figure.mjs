// The figure of lab 02: the depth that is stored for the distance d, between a near and a far plane, in so many bits.
import { clamp, range } from "../../grader/site/geometry.mjs";
import { fixed, percent } from "../../grader/site/numbers.mjs";

export const depth = (d, { near, far }) => ((far + near) / (far - near) - (2 * far * near) / ((far - near) * d) + 1) / 2;
export const distance = (stored, { near, far }) => (2 * near * far) / (far + near - (2 * stored - 1) * (far - near));

// How far apart two neighbouring depths lie at the distance d, in the world.
export const step = (d, { near, far, bits }) => (d * d * (far - near)) / (far * near) / 2 ** bits;

const wide = 11, far0 = 20, x = (d) => (d / far0) * wide, high = 3.2;

function draw(s, state) {
  const { near, far, thing } = state, d = clamp((thing[0] / wide) * far0, near, far), at = (way) => [x(way), high * depth(way, state)];
  s.arrow([0, 0], [wide + 0.4, 0], "line");
  s.arrow([0, 0], [0, high + 0.4], "line");
  s.path([[0, high], [x(far), high], [x(far), 0]], "dashed");
  s.path(range(201).map((i) => at(near + ((far - near) * i) / 200)), "eye");
  const half = (2 * near * far) / (near + far);
  s.path([[x(half), 0], [x(half), high / 2], [0, high / 2]], "beam");
  s.text([x(half), high / 2], "half of all depths", "e", "lamp");
  s.path([[x(d), 0], at(d), [0, at(d)[1]]], "mark");
  s.dot(at(d), "mark", 6);
  if (state.bits <= 6) for (const i of range(2 ** state.bits + 1)) s.line([x(distance(i / 2 ** state.bits, state)), 0], [x(distance(i / 2 ** state.bits, state)), -0.18], "line");
  s.text([x(near), 0], "n", "s");
  s.text([x(far), 0], "f", "s");
  s.text([0, high], "depth 1", "ne");
  s.text([wide, 0], "distance", "n", "quiet");
}

function numbers(state) {
  const { near, far, thing } = state, d = clamp((thing[0] / wide) * far0, near, far), stored = depth(d, state), apart = step(d, state);
  return [
    ["distance d", fixed(d)],
    ["stored depth", fixed(stored, 4)],
    ["back to a distance", fixed(distance(stored, state))],
    ["half of all depths lie before", fixed((2 * near * far) / (near + far))],
    ["so in this share of the way", percent(((2 * near * far) / (near + far) - near) / (far - near), 1)],
    ["neighbouring depths at d are apart", apart < 0.001 ? `${(apart * 1e6).toPrecision(2)} millionths` : fixed(apart, 3), apart > 0.2 ? "bad" : ""],
  ];
}

export const figure = {
  title: "Play: the stored depth.",
  about: "Drag the point along the distances, or move the planes. A near plane that is too near leaves few depths for what is far. With few bits the axis shows each of them.",
  view: { width: 640, height: 270, unit: 52, origin: [24, 226], text: "The curve of the stored depth over the distance" },
  knobs: {
    near: { label: "near plane n", least: 0.05, most: 4, step: 0.05, value: 1 },
    far: { label: "far plane f", least: 5, most: 20, step: 0.5, value: 16, digits: 1 },
    bits: { label: "bits", least: 3, most: 24, step: 1, value: 5, digits: 0 },
  },
  points: { thing: { label: "point at a distance", at: [3.3, 0], box: [[0, 0], [wide, 0]] } },
  draw, numbers,
};
