// The diagram of lab 09: edges that are toggled, and a volume that ends, with an eye in it.
import { add, along, meet, scale, sub, unit } from "../../grader/site/geometry.mjs";

const a = [0, 0], b = [3.2, 0], c = [1.3, 2.6], d = [4.5, 2.6];

// The way round a triangle, each edge moved inwards, so that one sees whose it is.
function way(s, corners, kind) {
  const middle = scale(corners.reduce(add), 1 / 3);
  corners.forEach((from, i) => {
    const to = corners[(i + 1) % 3], inwards = (point) => along(point, middle, 0.16);
    s.arrow(inwards(along(from, to, 0.25)), inwards(along(from, to, 0.75)), kind);
  });
  s.text(middle, "lit", "c");
}

function edges(s) {
  s.area([a, b, c], "lit");
  s.area([b, d, c], "lit");
  for (const [from, to] of [[a, b], [b, d], [d, c], [c, a]]) s.line(from, to, "surface");
  s.line(b, c, "dashed");
  way(s, [a, b, c], "mark");
  way(s, [b, d, c], "eye");
  s.text([2.25, -0.25], "The dashed edge comes twice, in", "s");
  s.text([2.25, -0.65], "opposite directions: out of the set.", "s");
}

function volume(s) {
  const lamp = [2.2, 5], left = [1.6, 3.3], right = [2.9, 3.3], low = 2.9, stretch = 1.5;
  const away = (point, k) => add(point, scale(sub(point, lamp), k));
  const ends = [away(left, stretch), away(right, stretch)];
  s.area([left, ends[0], ends[1], right], "half");
  for (const [corner, end] of [[left, ends[0]], [right, ends[1]]]) {
    s.line(lamp, corner, "beam");
    s.arrow(end, add(end, scale(unit(sub(corner, lamp)), 0.75)), "line");
    s.line(corner, end, "mark");
  }
  s.box([left[0], low], right, "solid");
  s.line(left, right, "lamp");
  s.line(...ends, "mark");
  s.text(left, "near cap", "w", "lamp");
  s.text(along(left, ends[0], 0.75), "side", "w", "mark");
  s.text(along(...ends, 0.5), "far cap", "n", "mark");
  s.text(right, "*p*", "e");
  s.text([ends[1][0] + 0.25, 0.4], "*p*′ = *p* + *k V*", "e", "mark");
  s.text([ends[1][0] + 0.25, 0], "or endless: (*V*, 0)", "e", "small");
  const eye = [2.0, 1.9], point = [5.5, 1.3], out = along(eye, point, meet(eye, point, right, ends[1]));
  s.arrow(eye, point, "eye");
  s.line(eye, lamp, "dashed");
  s.dot(out, "mark");
  s.text(out, "−1", "ne", "mark");
  s.eye(eye, point, "begin with 1", "w");
  s.text(point, "0: lit", "s", "eye");
  s.light(lamp, "lamp", "e");
}

export const diagrams = [{
  name: "volume", width: 640, height: 310, draw(s) {
    edges(s.panel({ origin: [28, 204], unit: 50 }));
    volume(s.panel({ origin: [280, 286], unit: 52 }));
  },
  title: "The silhouette and the volume behind it",
  text: "Left two lit triangles: their common edge is gone over twice, in opposite directions, and leaves the set; the others are the silhouette. Right a box under a lamp " +
    "and its shadow volume: the lit face as near cap, sides from each corner p to p′, and a far cap. The eye in the volume begins with 1 and leaves it: minus one, so the point is lit.",
}];
