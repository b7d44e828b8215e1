// The figure of lab 04: a thin wall at x = 0 on a floor at y = 0, under a sun whose way makes the angle theta with the
// floor's normal. Places in the map are t, depths grow away from the sun.
import { add, clamp, range, scale } from "../../grader/site/geometry.mjs";
import { fixed, percent } from "../../grader/site/numbers.mjs";

const CONSTANT = 0, SLOPE = 1, POLYGON = 2, NORMAL = 3, radius = 2.9;
const angle = ([x, y]) => Math.atan2(-x, y);
export const setup = (state) => ({ ...state, theta: angle(state.sun), height: state.top[1], size: 8 / state.texels });

// What the map keeps for the texel of t.
export function kept(t, { theta, height, size, method, factor }) {
  const middle = (Math.floor(t / size) + 0.5) * size, pushed = method === POLYGON ? factor * size : 0, slope = Math.tan(theta);
  const floor = middle * slope + pushed * slope;
  return middle > 0 && middle <= height * Math.sin(theta) ? Math.min(floor, -middle / slope + pushed / slope) : floor;
}

// How far the point that is looked up lies over the floor, and what is taken from its depth.
export const offset = ({ theta, size, method, normal }) => (method === NORMAL ? normal * size * Math.sin(theta) : 0);
export const bias = ({ theta, method, bias: b }) => (method === CONSTANT ? b : method === SLOPE ? b * (1 - Math.cos(theta)) : 0);

// Is the place x on the floor in shadow, by the map and in truth?
export function dark(x, scene) {
  const { theta } = scene, up = offset(scene);
  const t = x * Math.cos(theta) + up * Math.sin(theta), depth = x * Math.sin(theta) - up * Math.cos(theta);
  return kept(t, scene) < depth - bias(scene) - 1e-9;
}
export const trulyDark = (x, { theta, height }) => x > 0 && x < height * Math.tan(theta);

// Measured on the floor at many places: the share of acne far from the wall, the gap at its foot, the shift of the tip.
export function measured(scene) {
  const { theta, size, height } = scene, n = 4000, step = size / Math.cos(theta), tip = height * Math.tan(theta);
  const bare = range(n).filter((i) => dark(-step * (4 + (8 * (i + 0.5)) / n), scene)).length / n;
  const fine = tip / n, first = range(n).find((i) => dark((i + 0.5) * fine, scene)) ?? n;
  return { acne: bare, gap: first * fine };
}

// The same by formula. A box of the map is looked at along one axis only, so K is 1.
export function formulas({ theta, size, method, factor, normal, bias: b }) {
  const least = (size / 2) * Math.tan(theta), slope = Math.tan(theta);
  const share = method === NORMAL ? normal / 0.5 : method === POLYGON ? factor / 0.5 : bias({ theta, method, bias: b }) / least;
  const behind = method === POLYGON ? (factor * size) / slope : bias({ theta, method, bias: b });
  return { least, acne: Math.max(0, (1 - share) / 2), gap: behind * Math.sin(theta), tip: normal * size * Math.sin(theta) * slope * (method === NORMAL) };
}

function draw(s, state) {
  const scene = setup(state), { theta, size } = scene, [c, d] = [Math.cos(theta), Math.sin(theta)];
  const world = (t, depth) => add(scale([c, d], t), scale([d, -c], depth));
  const first = Math.ceil((-4.4 * c) / size), last = Math.floor((4.4 * c + 2 * d) / size);
  for (const i of range(last - first)) {
    const t = (first + i) * size, depth = kept(t + size / 2, scene);
    s.line(world(t, depth), world(t, depth - 8), "faint");
    s.line(world(t, depth), world(t + size, depth), "lamp");
  }
  s.line([-4.6, 0], [4.6, 0], "surface");
  const n = 920;
  let from = 0;
  const kind = (i) => ["", "blue", "yellow", "shade"][dark((i - 460) / 100, scene) + 2 * trulyDark((i - 460) / 100, scene)];
  for (let i = 1; i <= n; i++)
    if (i === n || kind(i) !== kind(from)) {
      if (kind(from)) s.line([(from - 460) / 100, 0], [(i - 460) / 100, 0], kind(from));
      from = i;
    }
  s.line([0, 0], state.top, "surface");
  s.arrow(state.sun, scale(state.sun, 0.62), "lamp");
  s.light(state.sun, "", "e");
}

function numbers(state) {
  const scene = setup(state), found = measured(scene), by = formulas(scene);
  return [
    ["angle θ", `${fixed((scene.theta * 180) / Math.PI, 0)}°`],
    ["texel s", fixed(scene.size, 3)],
    ["least bias b₀ = s/2 tan θ", fixed(by.least, 3)],
    ["acne, counted", percent(found.acne), found.acne > 0.005 ? "bad" : "good"],
    ["acne, by formula", percent(by.acne)],
    ["gap at the foot, counted", fixed(found.gap), found.gap > 1.5 * scene.size / Math.cos(scene.theta) ? "bad" : ""],
    ["gap, by formula (± a texel)", fixed(by.gap)],
    ["the shadow's tip moves", fixed(by.tip)],
  ];
}

export const figure = {
  title: "Play: acne, and the price of each cure.",
  about: "Orange is the depth that the map keeps, one for each texel. Drag the sun and the wall's top. Blue is acne; yellow, at the wall's foot, is the gap.",
  view: { width: 640, height: 300, unit: 68, origin: [320, 240], text: "A wall on a floor under the sun, from the side" },
  knobs: {
    method: { label: "method", choices: ["constant bias", "slope bias", "polygon offset", "normal offset"], value: CONSTANT },
    bias: { label: "bias", least: 0, most: 1, step: 0.01, value: 0.1, when: ({ method }) => method <= SLOPE },
    factor: { label: "factor", least: 0, most: 4, step: 0.1, value: 0.3, digits: 1, when: ({ method }) => method === POLYGON },
    normal: { label: "offset, texels", least: 0, most: 4, step: 0.05, value: 0.3, when: ({ method }) => method === NORMAL },
    texels: { label: "texels", least: 8, most: 80, step: 1, value: 20, digits: 0 },
  },
  points: {
    sun: { label: "sun", at: [-2.05, 2.05], box: [[-3, 0.5], [-0.3, 3]], keep: (p) => scale([-Math.sin(clamp(angle(p), 0.15, 1.35)), Math.cos(clamp(angle(p), 0.15, 1.35))], radius) },
    top: { label: "top of the wall", at: [0, 1.4], box: [[0, 0.4], [0, 2.2]] },
  },
  draw, numbers,
};
