// The diagram of lab 12: a place on a face and its luxel in the chart, with the padding that dilation fills.
import { add, along, range, scale } from "../../grader/site/geometry.mjs";

const columns = 6, rows = 4, place = [3.5 / columns, 1.5 / rows]; // (s, t): the middle of a luxel

function face(s) {
  const corner = [0, 0], right = [3.4, 0.55], up = [1.6, 1.9];
  const at = ([u, v]) => add(corner, add(scale(right, u), scale(up, v)));
  s.area([[0, 0], [1, 0], [1, 1], [0, 1]].map(at), "lit");
  for (const i of range(columns + 1)) s.line(at([i / columns, 0]), at([i / columns, 1]), "faint");
  for (const i of range(rows + 1)) s.line(at([0, i / rows]), at([1, i / rows]), "faint");
  s.area([[0, 0], [1, 0], [1, 1], [0, 1]].map(at), "line");
  const point = at(place), lamp = [1.5, 4.6], normal = add(point, [0, 1.5]);
  s.line(lamp, point, "lamp");
  s.arrow(point, normal, "line");
  s.text(normal, "*n*", "e");
  s.text(along(lamp, point, 0.4), "*r*", "w", "lamp");
  s.angle(point, normal, lamp, 0.8, "*θ*");
  s.dot(point, "mark");
  s.text(at([0, 0]), "(0, 0)", "s");
  s.text(at([1, 1]), "(1, 1)", "n");
  s.text([2.4, -0.5], "the place (*s*, *t*) of a face", "s");
  s.light(lamp, "lamp", "w");
}

function chart(s) {
  const left = 2, bottom = 1;
  s.box([0, 0], [columns + 4, 8], "half");
  s.box([left, bottom], [left + columns, bottom + rows], "open");
  s.box([left, bottom], [left + columns, bottom + rows], "lit");
  for (const i of range(columns + 3)) s.line([left - 1 + i, bottom - 1], [left - 1 + i, bottom + rows + 1], "faint");
  for (const i of range(rows + 3)) s.line([left - 1, bottom - 1 + i], [left + columns + 1, bottom - 1 + i], "faint");
  s.box([left - 1, bottom - 1], [left + columns + 1, bottom + rows + 1], "beam");
  s.box([left, bottom], [left + columns, bottom + rows], "line");
  s.dot([left + place[0] * columns, bottom + place[1] * rows], "mark");
  for (const y of range(rows)) s.arrow([left + 0.5, bottom + y + 0.5], [left - 0.5, bottom + y + 0.5], "mark"); // dilation copies outwards
  s.box([1, 6.9], [4, 8], "open");
  s.box([5, 6.9], [8.5, 8], "open");
  s.text([2.5, 7.45], "other charts", "c", "small");
  s.text([6.75, 7.45], "other charts", "c", "small");
  s.text([left - 1, bottom + rows + 1], "padding, filled by dilation", "ne", "mark", -4);
  s.text([5, 0], "its chart in the light map of *W* × *H* luxels", "s");
}

export const diagrams = [{
  name: "luxel", width: 640, height: 320, draw(s) {
    face(s.panel({ origin: [34, 250], unit: 48 }));
    s.arrow([262, 140], [306, 140], "line");
    chart(s.panel({ origin: [314, 278], unit: 30 }));
  },
  title: "A face and its chart in the light map",
  text: "Left a face under a lamp, with a place (s, t), its normal n, the distance r and the angle theta. Right the chart of the face in the light map, with the luxel of the same place, " +
    "and the padding of one luxel around it: dilation copies the luxels of the border into it.",
}];
