// The figure of lab 11: a lamp in a room, cut through the middle: four faces of its cube, each a map of few texels.
import { add, clamp, dot, length, range, scale, sub } from "../../grader/site/geometry.mjs";
import { fixed } from "../../grader/site/numbers.mjs";

const near = 0.5, far = 10, room = [[0, 0], [14, 6]], radius = 0.6;

// The depth in [0, 1] of what lies `m` along the axis of the face that sees it.
export const depth = (m) => ((far + near) / (far - near) - (2 * far * near) / ((far - near) * m) + 1) / 2;

// The face that a direction from the lamp goes through, and how far it goes along the face's axis.
export function faceOf([x, y]) {
  const m = Math.max(Math.abs(x), Math.abs(y));
  return { m, name: Math.abs(x) >= Math.abs(y) ? (x >= 0 ? "+x" : "−x") : y >= 0 ? "+y" : "−y" };
}

// The middle of the texel that a direction goes through, as a direction to a face at the distance 1.
export function texelWay(way, texels) {
  const { m } = faceOf(way);
  return way.map((x) => (Math.abs(x) === m ? Math.sign(x) : (Math.min(Math.floor(((x / m + 1) / 2) * texels), texels - 1) + 0.5) * (2 / texels) - 1));
}

// How far along a direction the nearest surface is, in its own lengths: a wall of the room, or the ball.
export function nearest(way, { lamp, ball }) {
  const walls = [0, 1].map((i) => (way[i] === 0 ? Infinity : ((way[i] > 0 ? room[1] : room[0])[i] - lamp[i]) / way[i]));
  const a = dot(way, way), b = dot(way, sub(lamp, ball)), c = dot(sub(lamp, ball), sub(lamp, ball)) - radius ** 2, root = b * b - a * c;
  const hit = root < 0 ? -1 : (-b - Math.sqrt(root)) / a;
  return Math.min(...walls, hit > 0 ? hit : Infinity);
}

// What a texel keeps: m of the nearest surface on the ray through its middle.
export const kept = (way, state) => nearest(texelWay(way, state.texels), state);
export const hidden = (point, state) => nearest(sub(point, state.lamp), state) < 1 - 1e-9;

function draw(s, state) {
  const { lamp, ball, point, texels } = state, way = sub(point, lamp), { m, name } = faceOf(way);
  s.box(...room, "surface");
  for (const corner of [[1, 1], [1, -1], [-1, 1], [-1, -1]]) s.line(lamp, add(lamp, scale(corner, nearest(corner, state))), "dashed");
  s.box(sub(lamp, [0.5, 0.5]), add(lamp, [0.5, 0.5]), "line");
  for (const face of range(4))
    for (const i of range(texels)) {
      const place = (2 * (i + 0.5)) / texels - 1, to = [[1, place], [-1, place], [place, 1], [place, -1]][face];
      s.dot(add(lamp, scale(to, nearest(to, state))), "lamp", 3);
    }
  s.circle(ball, radius, "solid");
  const along = name.endsWith("x") ? [point[0], lamp[1]] : [lamp[0], point[1]];
  s.line(lamp, along, "mark");
  s.line(along, point, "dashed");
  s.text(scale(add(lamp, along), 0.5), "*m*", "s", "mark");
  s.line(lamp, point, "eye");
  s.dot(point, "eye", 6);
  s.light(lamp, "");
}

function numbers(state) {
  const way = sub(state.point, state.lamp), { m, name } = faceOf(way), map = kept(way, state), dark = map < m - state.bias;
  return [
    ["face, m", `${name}, ${fixed(m)}`],
    ["depth of m", fixed(depth(clamp(m, near, far)), 4)],
    ["kept in the texel, as depth", fixed(depth(clamp(map, near, far)), 4)],
    ["so the point is", `${dark ? "dark" : "lit"}, ${dark === hidden(state.point, state) ? "right" : "wrong: too few texels"}`, dark === hidden(state.point, state) ? "good" : "bad"],
    ["distance |d|", fixed(length(way))],
    ["depth of |d|: a mistake", fixed(depth(clamp(length(way), near, far)), 4), "bad"],
  ];
}

export const figure = {
  title: "Play: a cube of maps.",
  about: "Each orange dot is what one texel keeps. Drag lamp, ball and point over the dashed seams: the face changes, m and the depth do not jump.",
  view: { width: 640, height: 300, unit: 44, origin: [12, 282], text: "A lamp with its cube, a ball and a point in a room, from the side" },
  knobs: {
    texels: { label: "texels a face", least: 2, most: 64, step: 1, value: 16, digits: 0 },
    bias: { label: "bias along m", least: 0, most: 1, step: 0.05, value: 0.1 },
  },
  points: {
    lamp: { label: "lamp", at: [5, 3], box: [[0.7, 0.7], [13.3, 5.3]] },
    ball: { label: "ball", at: [8, 3.3], box: [[0.7, 0.7], [13.3, 5.3]], keep: (p, { lamp }) => (length(sub(p, lamp)) < 1 ? add(lamp, scale(sub(p, lamp), 1 / Math.max(length(sub(p, lamp)), 0.01))) : p) },
    point: { label: "point", at: [12.5, 3.9], box: [[0.1, 0.1], [13.9, 5.9]] },
  },
  draw, numbers,
};
