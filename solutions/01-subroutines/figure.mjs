// The figure of lab 01: one point of a surface, with the normal straight up, under a lamp and before an eye.
import { along, clamp, dot, scale, sub, unit } from "../../grader/site/geometry.mjs";
import { fixed } from "../../grader/site/numbers.mjs";

const normal = [0, 1], ambientLight = 0.2, color = 0.7, lampLight = 0.8, specular = 0.4;
const AMBIENT = 0, PHONG = 2, POSTERISED = 1;

// The unit vectors at the point (0, 0), and what the models need of them.
export function vectors({ lamp, eye }) {
  const l = unit(lamp), v = unit(eye), r = sub(scale(normal, 2 * dot(normal, l)), l);
  return { l, v, r, facing: dot(normal, l), mirrored: dot(r, v) };
}

export function shade(state) {
  const { facing, mirrored } = vectors(state), base = ambientLight * color;
  if (state.model === AMBIENT) return base;
  const diffuse = base + lampLight * color * Math.max(facing, 0);
  return state.model === PHONG && facing > 0 ? diffuse + lampLight * specular * Math.max(mirrored, 0) ** state.shininess : diffuse;
}

export const finish = (value, state) => (state.finish === POSTERISED ? Math.floor(4 * value + 0.5) / 4 : value);

function draw(s, state) {
  const { lamp, eye } = state, { l, v, r, facing } = vectors(state), value = clamp(finish(shade(state), state), 0, 1);
  s.line([-5.6, 0], [5.6, 0], "surface");
  s.line(lamp, scale(l, 1.6), "beam");
  s.arrow([0, 0], scale(normal, 1.6), "line");
  s.arrow([0, 0], scale(l, 1.6), "lamp");
  if (facing > 0) s.arrow([0, 0], scale(r, 1.6), "mark");
  s.arrow([0, 0], scale(v, 1.6), "eye");
  for (const [name, way] of [["n", normal], ["l", l], ["v", v], ["r", r]]) if (name !== "r" || facing > 0) s.text(scale(way, 1.85), `*${name}*`, "c");
  s.box([3.9, 2.9], [5.4, 4.1], "line");
  s.box([3.9, 2.9], [3.9 + 1.5 * value, 4.1], "lit"); // a bar: how bright
  s.text([4.65, 2.9], "brightness", "s", "small");
  s.light(lamp, "");
  s.eye(eye, along(eye, [0, 0], 1), "");
}

function numbers(state) {
  const { facing, mirrored } = vectors(state), value = shade(state);
  return [
    ["n · l", fixed(facing, 3)],
    ["r · v", fixed(mirrored, 3)],
    ["max(r · v, 0) to the power of e", fixed(Math.max(mirrored, 0) ** state.shininess, 3)],
    ["the model's value", fixed(value, 3)],
    ["after the finish", fixed(finish(value, state), 3)],
  ];
}

export const figure = {
  title: "Play: choose a function.",
  about: "Drag the lamp and the eye, and choose the model and the finish, as the two pointers do. (Here ambient light is 0.2, the lamp 0.8, the colour 0.7, the specular reflectance 0.4.)",
  view: { width: 640, height: 300, unit: 56, origin: [320, 258], text: "A point of a surface with its vectors to lamp and eye" },
  knobs: {
    model: { label: "u_shade", choices: ["ambient", "diffuse", "Phong"], value: 2 },
    finish: { label: "u_finish", choices: ["plain", "posterised"], value: 0 },
    shininess: { label: "shininess e", least: 1, most: 100, step: 1, value: 10, digits: 0 },
  },
  points: {
    lamp: { label: "lamp", at: [-2.6, 3.2], box: [[-5.2, -0.6], [5.2, 4.2]] },
    eye: { label: "eye", at: [3.4, 2.4], box: [[-5.2, 0.3], [5.2, 4.2]] },
  },
  draw, numbers,
};
