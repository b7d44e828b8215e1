// The diagram of lab 07: a ray through the volumes of two casters, and another that begins in one of them.
import { along, cross, fall, meet, sub } from "../../grader/site/geometry.mjs";

const lamp = [6.2, 6.2], floor = 0;
const boxes = [[[4.2, 3.7], [5.1, 4.3]], [[7.6, 3.0], [8.5, 3.6]]];
const corners = ([[x, y], [u, v]]) => [[x, y], [u, y], [u, v], [x, v]]; // counter-clockwise

// The lit sides of a box, and its two corners on the silhouette, left and right.
function seen(box) {
  const all = corners(box), lit = all.map((corner, i) => cross(sub(all[(i + 1) % 4], corner), sub(lamp, corner)) < 0);
  const rims = all.filter((_, i) => lit[i] !== lit[(i + 3) % 4]).sort((a, b) => fall(lamp, a)[0] - fall(lamp, b)[0]);
  return { rims, caps: all.flatMap((corner, i) => (lit[i] ? [[corner, all[(i + 1) % 4]]] : [])), all };
}

function volume(s, { rims: [left, right], caps }) {
  const near = caps.flat().filter((p) => p !== left && p !== right);
  s.area([fall(lamp, left, floor), left, ...near.slice(0, 1), right, fall(lamp, right, floor)], "half");
  for (const corner of [left, right]) s.line(corner, fall(lamp, corner, floor - 1), "line");
}

function draw(s) {
  const both = boxes.map(seen), sides = both.map(({ rims }) => rims);
  both.forEach((box) => volume(s, box));
  s.line([0.2, floor], [14.4, floor], "surface");
  for (const box of boxes) s.box(...box, "solid");
  for (const [a, b] of both.flatMap(({ caps }) => caps)) s.line(a, b, "lamp");
  s.text(boxes[1][1], "near caps: lit faces", "e", "lamp");
  const eye = [0.8, 3.2], point = [9.9, floor];
  const crossing = (from, to, rim) => along(from, to, meet(from, to, lamp, rim));
  const hits = [...sides[0], sides[1][0]].map((rim) => crossing(eye, point, rim)), behind = crossing(eye, point, sides[1][1]);
  s.arrow(eye, point, "eye");
  s.line(point, along(point, behind, 1.3), "dashed");
  hits.forEach((hit, i) => {
    s.dot(hit, "mark");
    s.text(hit, ["+1", "−1", "+1"][i], "ne", "mark");
  });
  s.dot(point, "eye");
  s.text(point, "1 − 1 + 1 = 1: dark", "ne");
  s.dot(behind, "mark");
  s.text(behind, "z-fail counts what is behind the point: +1", "w", "mark");
  const inside = [2.4, 1.1], lit = [6.6, floor], out = crossing(inside, lit, sides[0][1]);
  s.arrow(inside, lit, "eye");
  s.dot(out, "mark");
  s.text(out, "−1", "ne", "mark");
  s.eye(eye, point, "eye", "n");
  s.eye(inside, lit, "eye inside", "s");
  s.light(lamp, "lamp", "e");
}

export const diagrams = [{
  name: "volumes", width: 620, height: 350, unit: 42, origin: [8, 292], draw,
  title: "Counting shadow volumes along a ray",
  text: "Two boxes under a lamp, with the shadow volumes behind them. The eye's ray enters the first volume, plus one, leaves it, minus one, and enters the second, plus one: " +
    "the point on the floor has the count 1 and is dark. Behind the point the ray leaves the second volume: z-fail counts this one. A second eye stands in the first volume: its ray " +
    "only leaves, so z-pass has minus one for a lit point.",
}];
