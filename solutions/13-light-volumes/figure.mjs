// The figure of lab 13: the eye's ray through the shadows of two boards under a lamp, in dust that scatters 1 on each unit.
import { along, length, meet, range, scale, sub, add } from "../../grader/site/geometry.mjs";
import { fixed, percent } from "../../grader/site/numbers.mjs";

const wide = 1.1;
export const ends = ([x, y]) => [[x - wide / 2, y], [x + wide / 2, y]];

// What dust up to the distance d would send.
export const gathered = (d, a) => (a === 0 ? d : (1 - Math.exp(-a * d)) / a);

// Does the lamp see the place? No board lies on the way.
export function lit(place, { lamp, boards }) {
  return boards.every((board) => {
    const [a, b] = ends(board), t = meet(place, lamp, a, b), u = meet(a, b, place, lamp);
    return !(t > 0 && t < 1 && u >= 0 && u <= 1);
  });
}

// The lit pieces of the ray, as distances from the eye: it changes only where a volume's side or a board is crossed.
export function pieces(scene) {
  const { eye, end, lamp, boards } = scene, far = length(sub(end, eye));
  const lines = boards.flatMap((board) => [[lamp, ends(board)[0]], [lamp, ends(board)[1]], ends(board)]);
  const cuts = lines.map(([a, b]) => meet(eye, end, a, b)).filter((t) => t > 0 && t < 1);
  const all = [0, ...cuts.sort((a, b) => a - b), 1];
  return range(all.length - 1).filter((i) => lit(along(eye, end, (all[i] + all[i + 1]) / 2), scene)).map((i) => [all[i] * far, all[i + 1] * far]);
}

export const exact = (scene) => pieces(scene).reduce((sum, [from, to]) => sum + gathered(to, scene.loss) - gathered(from, scene.loss), 0);

// The sum over the steps, each asked at the share `place` of it.
export function march(scene) {
  const { eye, end, steps, place, loss } = scene, far = length(sub(end, eye)), step = far / steps;
  return range(steps).reduce((sum, i) => {
    const t = (i + place) * step;
    return sum + lit(along(eye, end, t / far), scene) * Math.exp(-loss * t) * step;
  }, 0);
}

const scene = (state) => ({ ...state, boards: [state.first, state.second] });

function draw(s, state) {
  const all = scene(state), { eye, end, lamp, boards, steps, place, loss } = all, far = length(sub(end, eye)), at = (t) => along(eye, end, t / far);
  for (const board of boards) {
    const [a, b] = ends(board), away = (p) => add(p, scale(sub(p, lamp), 40 / length(sub(p, lamp))));
    s.area([a, away(a), away(b), b], "half");
    s.line(a, b, "surface");
  }
  s.box([-1, -6], [20, 0], "card");
  s.line([0, 0], [15, 0], "surface");
  for (const [from, to] of pieces(all)) s.line(at(from), at(to), "yellow");
  s.arrow(eye, end, "eye");
  const under = s.panel({ origin: [40, 424], unit: 38 }), high = 2.2, arrives = (t) => high * Math.exp(-loss * t);
  for (const i of range(steps)) {
    const [from, to] = [(i * far) / steps, ((i + 1) * far) / steps], t = from + place * (to - from);
    if (lit(at(t), all)) under.box([from, 0], [to, arrives(t)], "lit");
    under.line([from, 0], [from, lit(at(t), all) ? arrives(t) : 0.08], "faint");
    s.dot(at(t), lit(at(t), all) ? "lamp" : "", 3.5);
  }
  for (const [from, to] of pieces(all)) under.path([[from, 0], ...range(25).map((i) => from + ((to - from) * i) / 24).map((t) => [t, arrives(t)]), [to, 0]], "lamp");
  under.line([0, 0], [far, 0], "line");
  s.eye(eye, end, "");
  s.light(lamp, "");
}

function numbers(state) {
  const all = scene(state), right = exact(all), found = march(all), far = length(sub(state.end, state.eye));
  const bright = pieces(all).reduce((sum, [from, to]) => sum + to - from, 0);
  return [
    ["lit part of the way", `${fixed(bright)} of ${fixed(far)}`],
    ["exactly, by faces", fixed(right, 3)],
    [`by ${state.steps} steps`, fixed(found, 3)],
    ["error of the steps", right > 0 ? percent((found - right) / right, 1) : fixed(found, 3), Math.abs(found - right) > 0.05 * right ? "bad" : "good"],
    ["left of a light at D, e⁻ᵃᴰ", percent(Math.exp(-state.loss * far))],
    ["without shadows, G(D)", fixed(gathered(far, state.loss), 3)],
  ];
}

export const figure = {
  title: "Play: light in the dust.",
  about: "Drag lamp, boards, eye and the ray's end. Yellow parts of the ray are lit. Below: what arrives from each place, exactly (line) and by steps (boxes).",
  view: { width: 640, height: 440, unit: 42, origin: [10, 318], text: "A ray through the shadows of two boards under a lamp, and what arrives from each place of it" },
  knobs: {
    steps: { label: "steps", least: 1, most: 64, step: 1, value: 8, digits: 0 },
    place: { label: "place in a step", least: 0, most: 1, step: 0.05, value: 0.5 },
    loss: { label: "extinction a", least: 0, most: 0.5, step: 0.01, value: 0.1 },
  },
  points: {
    lamp: { label: "lamp", at: [7, 7], box: [[1, 6.2], [14, 7.2]] },
    first: { label: "first board", at: [6.2, 5], box: [[1, 1], [14, 5.8]] },
    second: { label: "second board", at: [8.8, 4.4], box: [[1, 1], [14, 5.8]] },
    eye: { label: "eye", at: [0.6, 4], box: [[0.3, 0.4], [5, 5.8]] },
    end: { label: "end of the ray", at: [14, 0], box: [[6, 0], [14.6, 0]] },
  },
  draw, numbers,
};
