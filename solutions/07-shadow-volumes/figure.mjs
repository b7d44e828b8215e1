// The figure of lab 07: two boxes under a lamp over a floor at y = 0, and the faces of their volumes along the eye's ray.
// A face is a piece of a line: from `at`, along `way`, up to `end` times it; `out` looks out of the volume.
import { add, along, dot, meet, range, scale, sub } from "../../grader/site/geometry.mjs";
import { signed } from "../../grader/site/numbers.mjs";

const half = [0.55, 0.4];
export const corners = ([x, y]) => [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([i, j]) => [x + i * half[0], y + j * half[1]]); // counter-clockwise
const outwards = ([x, y]) => [y, -x];

// The faces of a box's volume: near caps, and two sides without an end.
export function faces(box, lamp) {
  const all = corners(box), lit = range(4).map((i) => dot(outwards(sub(all[(i + 1) % 4], all[i])), sub(lamp, all[i])) > 0);
  const caps = range(4).filter((i) => lit[i]).map((i) => ({ cap: true, at: all[i], way: sub(all[(i + 1) % 4], all[i]), end: 1, out: outwards(sub(all[(i + 1) % 4], all[i])) }));
  const sides = range(4).filter((i) => lit[i] !== lit[(i + 3) % 4]).map((i) => {
    const way = sub(all[i], lamp), out = outwards(way), inner = all.some((other) => dot(out, sub(other, all[i])) > 1e-9);
    return { cap: false, at: all[i], way, end: Infinity, out: inner ? scale(out, -1) : out };
  });
  return [...caps, ...sides];
}

// Where the ray from a through b crosses the faces: t, counted in ways from a to b, and +1 where it enters.
export function crossings(a, b, box, lamp) {
  return faces(box, lamp).flatMap((face) => {
    const to = add(face.at, face.way), t = meet(a, b, face.at, to), u = meet(face.at, to, a, b);
    return t > 0 && u >= 0 && u < face.end ? [{ t, sign: dot(sub(b, a), face.out) < 0 ? 1 : -1, cap: face.cap }] : [];
  });
}

// Does the ray stay in the volume for ever? Then it leaves through the far cap.
export function endsInside(a, b, box, lamp) {
  const [p, q] = faces(box, lamp).filter(({ cap }) => !cap), way = sub(b, a);
  return dot(way, p.out) < 0 && dot(way, q.out) < 0;
}

// Is anything of the box between the point and the lamp? This is the truth, by a ray.
export function hidden(point, box, lamp) {
  const all = corners(box);
  const hit = range(4).some((i) => {
    const t = meet(point, lamp, all[i], all[(i + 1) % 4]), u = meet(all[i], all[(i + 1) % 4], point, lamp);
    return t > 1e-9 && t < 1 && u >= 0 && u < 1;
  });
  return hit;
}

// What the eye sees: the first box on the ray, or the floor; a little nearer, as the polygon offset has it.
export function seen({ eye, target, boxes }) {
  const hits = boxes.flatMap((box) => range(4).flatMap((i) => {
    const [a, b] = [corners(box)[i], corners(box)[(i + 1) % 4]], t = meet(eye, target, a, b), u = meet(a, b, eye, target);
    return t > 0 && t < 1 && u >= 0 && u <= 1 ? [t] : [];
  }));
  return along(eye, target, Math.min(1, ...hits) - 1e-6);
}

export function counts({ eye, lamp, boxes, capped = 1 }, point) {
  const all = boxes.map((box) => crossings(eye, point, box, lamp).filter(({ cap }) => capped || !cap));
  const sum = (list) => list.reduce((total, { sign }) => total + sign, 0) + 0;
  const far = capped ? boxes.filter((box) => endsInside(eye, point, box, lamp)).length : 0;
  return {
    pass: sum(all.flat().filter(({ t }) => t < 1)), fail: far - sum(all.flat().filter(({ t }) => t > 1)),
    around: boxes.filter((box) => hidden(eye, box, lamp)).length, truth: boxes.filter((box) => hidden(point, box, lamp)).length,
  };
}

const scene = (state) => ({ ...state, boxes: [state.left, state.right] });

function draw(s, state) {
  const all = scene(state), { lamp, eye, boxes, method, capped } = all, point = seen(all);
  for (const box of boxes) {
    const sides = faces(box, lamp).filter(({ cap }) => !cap).map(({ at }) => at);
    const end = (p) => add(p, scale(sub(p, lamp), 30 / Math.max(Math.hypot(...sub(p, lamp)), 0.1)));
    s.area([sides[0], end(sides[0]), end(sides[1]), sides[1]], "half");
    for (const p of sides) s.line(p, end(p), "line");
    s.area(corners(box), "solid");
    if (capped) for (const { cap, at, way } of faces(box, lamp)) if (cap) s.line(at, add(at, way), "lamp");
  }
  s.line([-1, 0], [15, 0], "surface");
  s.line(point, along(eye, point, 60), "dashed");
  s.arrow(eye, point, "eye");
  for (const box of boxes)
    for (const { t, sign, cap } of crossings(eye, point, box, lamp)) {
      if ((cap && !capped) || (method === 0 ? t > 1 : t < 1)) continue;
      s.dot(along(eye, point, t), "mark");
      s.text(along(eye, point, t), signed(method === 0 ? sign : -sign), "ne", "mark");
    }
  s.eye(eye, point, "");
  s.light(lamp, "", "e");
}

function numbers(state) {
  const all = scene(state), { pass, fail, around, truth } = counts(all, seen(all)), count = state.method === 0 ? pass : fail;
  const right = (count !== 0) === (truth > 0);
  return [
    [state.method === 0 ? "counted before the point" : "counted behind the point", signed(count)],
    ["so the point is", `${count === 0 ? "lit" : "dark"}: ${right ? "right" : "wrong"}`, right ? "good" : "bad"],
    ["volumes around the point", String(truth)],
    ["volumes around the eye", String(around)],
  ];
}

export const figure = {
  title: "Play: count the faces.",
  about: "Drag lamp, boxes, eye and the place on the floor that it looks at. Move the eye into a volume: z-pass is wrong by their number. Far caps are too far away to be drawn.",
  view: { width: 640, height: 330, unit: 44, origin: [14, 284], text: "A lamp, two boxes with their shadow volumes, and the ray from an eye to the floor" },
  knobs: {
    method: { label: "method", choices: ["z-pass: faces before", "z-fail: faces behind"], value: 0 },
    capped: { label: "caps", choices: ["none", "near and far"], value: 1 },
  },
  points: {
    lamp: { label: "lamp", at: [5, 6], box: [[0, 4.9], [14, 6.2]] },
    eye: { label: "eye", at: [1, 3.1], box: [[0, 0.3], [14, 4.4]] },
    left: { label: "left box", at: [4.6, 3.8], box: [[1, 0.8], [6, 4.2]] },
    right: { label: "right box", at: [8, 2.9], box: [[7.2, 0.8], [13, 4.2]] },
    target: { label: "place on the floor", at: [10.4, 0], box: [[0, 0], [14, 0]] },
  },
  draw, numbers,
};
