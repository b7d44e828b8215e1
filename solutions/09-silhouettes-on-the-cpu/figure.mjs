// The figure of lab 09: a caster of triangles under a lamp. Its lit triangles are gone over one by one, and their edges toggled
// in a set. Places are [x, y, z] with y up; the plan on the left shows x and z.
import { range } from "../../grader/site/geometry.mjs";

const shapes = [
  [[0, 0], [0, 1.6], [1.6, 1.6], [1.6, 0]], // plans, z away from the viewer; the corner that all others see comes first
  [[1, 1], [0, 1], [0, 2], [2, 2], [2, 0], [1, 0]],
];
const minus = (a, b) => a.map((x, i) => x - b[i]);
const dot3 = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
export const cross3 = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];

// The corners of a shape that stands on the floor, and its triangles, counter-clockwise seen from outside.
export function caster(shape, height = 1.2) {
  const plan = shapes[shape], n = plan.length, corners = [0, height].flatMap((y) => plan.map(([x, z]) => [x - 1, y, z - 1]));
  const caps = range(n - 2).flatMap((i) => [[n, n + i + 1, n + i + 2], [0, i + 2, i + 1]]);
  const walls = range(n).flatMap((i) => [[(i + 1) % n, n + ((i + 1) % n), n + i], [(i + 1) % n, n + i, i]]);
  return { corners, triangles: [...caps, ...walls] };
}

export const litTriangles = ({ corners, triangles }, lamp) => triangles.filter(([a, b, c]) => {
  const out = cross3(minus(corners[b], corners[a]), minus(corners[c], corners[a]));
  return dot3(out, minus(lamp, corners[a])) > 0;
});

// The set after so many triangles. Two edges are the same when their ends are; with `directed`, only in the same direction.
export function edgeSet(triangles, directed) {
  const set = new Map();
  for (const [a, b, c] of triangles)
    for (const [from, to] of [[a, b], [b, c], [c, a]]) {
      const key = directed || from < to ? `${from} ${to}` : `${to} ${from}`;
      if (!set.delete(key)) set.set(key, [from, to]);
    }
  return [...set.values()];
}

const lampOf = ({ lamp, height }) => [lamp[0], height, lamp[1]];

function draw(s, state) {
  const mesh = caster(state.shape), { corners, triangles } = mesh, lamp = lampOf(state), lit = litTriangles(mesh, lamp), over = lit.slice(0, state.over);
  const edges = edgeSet(over, state.same === 1);
  const plan = shapes[state.shape].map(([x, z]) => [x - 1, z - 1]);
  s.box([-2.3, -2.3], [2.3, 2.3], "faint");
  s.area(plan, "half");
  s.text([0, -2.3], "from above", "s", "small");
  s.light(state.lamp, "");
  const view = s.panel({ origin: [430, 214], unit: 58 }), flat = ([x, y, z]) => [x + 0.45 * z, y + 0.35 * z];
  const toViewer = [0.45, 0.35, -1], at = (i) => flat(corners[i]);
  if (state.stretch > 0) {
    const away = (i) => corners[i].map((x, k) => x + state.stretch * (x - lamp[k]));
    for (const [a, b] of edges) view.area([at(a), flat(away(a)), flat(away(b)), at(b)], "half");
  }
  for (const [a, b, c] of triangles) {
    const seen = dot3(cross3(minus(corners[b], corners[a]), minus(corners[c], corners[a])), toViewer) > 0;
    view.area([at(a), at(b), at(c)], seen ? "line" : "faint");
  }
  for (const [a, b, c] of over) view.area([at(a), at(b), at(c)], "lit");
  for (const [a, b] of edges) view.line(at(a), at(b), "mark");
  for (const [a, b] of edges) view.dot(at(a), "mark", 3.5);
  view.light(flat(lamp), "");
}

function numbers(state) {
  const mesh = caster(state.shape), lit = litTriangles(mesh, lampOf(state)), over = lit.slice(0, state.over), edges = edgeSet(over, state.same === 1);
  const degree = mesh.corners.map((_, i) => edges.filter((edge) => edge.includes(i)).length), done = over.length === lit.length;
  return [
    ["lit triangles", `${lit.length} of ${mesh.triangles.length}`],
    ["gone over", `${over.length}, ${3 * over.length} edges toggled`],
    ["edges in the set", String(edges.length)],
    ["twice, so out of it", String((3 * over.length - edges.length) / 2)],
    ["most edges at a corner", String(Math.max(...degree)), degree.some((n) => n % 2) ? "bad" : ""],
    ["the silhouette", done ? (state.same === 1 ? "wrong: no edge goes out" : `${edges.length} edges`) : "not yet complete", done && state.same === 0 ? "good" : "bad"],
  ];
}

export const figure = {
  title: "Play: toggle the edges.",
  about: "Drag the lamp in the plan on the left. Let triangles be gone over one by one: an edge between two of them comes twice and goes out. With stretch the sides of the volume appear.",
  view: { width: 640, height: 310, unit: 48, origin: [130, 140], text: "A caster under a lamp, from above and in space, with its silhouette" },
  knobs: {
    shape: { label: "caster", choices: ["box", "L"], value: 0 },
    over: { label: "gone over", least: 0, most: 20, step: 1, value: 20, digits: 0 },
    same: { label: "edges are the same", choices: ["in both directions", "in one: a mistake"], value: 0 },
    height: { label: "lamp's height", least: 0.2, most: 3.2, step: 0.1, value: 2.6, digits: 1 },
    stretch: { label: "stretch k", least: 0, most: 2, step: 0.1, value: 0, digits: 1 },
  },
  points: { lamp: { label: "lamp", at: [-1.6, -1.5], box: [[-2.2, -2.2], [2.2, 2.2]] } },
  draw, numbers,
};
