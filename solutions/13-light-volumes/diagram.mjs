// The diagram of lab 13: a ray through the shadows of two boards, and what reaches the eye from each place on it.
import { along, fall, length, meet, range, sub } from "../../grader/site/geometry.mjs";

const lamp = [7.2, 6.5], eye = [0.6, 4.2], end = [14.6, 0], ground = 0;
const boards = [[[6, 4.9], [7, 4.9]], [[8.4, 4.3], [9.1, 4.3]]];
const far = length(sub(end, eye)), loss = 0.13; // extinction

// Enters and leaves, as shares of the way from the eye to the end.
const dark = boards.map((board) => board.map((edge) => meet(eye, end, lamp, edge)));

function space(s) {
  for (const [a, b] of boards) s.area([a, b, fall(lamp, b, ground), fall(lamp, a, ground)], "dark");
  for (const edge of boards.flat()) s.line(lamp, fall(lamp, edge, ground), "beam");
  s.line([0, ground], [15.2, ground], "surface");
  for (const [a, b] of boards) s.line(a, b, "surface");
  const marks = [0, ...dark.flat(), 1].map((t) => along(eye, end, t));
  for (const i of [0, 2, 4]) s.line(marks[i], marks[i + 1], "yellow");
  s.arrow(eye, end, "eye");
  dark.forEach(([enters, leaves], i) => {
    s.dot(along(eye, end, enters), "mark");
    s.dot(along(eye, end, leaves), "mark");
    s.text(along(eye, end, enters), i ? "" : "*t*₀", "sw", "mark");
    s.text(along(eye, end, leaves), i ? "" : "*t*₁", "ne", "mark");
  });
  s.text(end, "*D*", "n");
  s.eye(eye, end, "eye", "n");
  s.light(lamp, "lamp", "e");
}

function curve(s) {
  const arrives = (t) => Math.exp(-loss * far * t), points = (from, to) => range(33).map((i) => from + ((to - from) * i) / 32).map((t) => [t * far, 1.7 * arrives(t)]);
  s.path(points(0, 1), "dashed");
  const edges = [0, ...dark.flat(), 1];
  for (const i of [0, 2, 4]) s.area([[edges[i] * far, 0], ...points(edges[i], edges[i + 1]), [edges[i + 1] * far, 0]], "lit");
  s.line([0, 0], [far, 0], "line");
  s.line([0, 0], [0, 1.9], "line");
  for (const [i, t] of dark.flat().entries()) s.text([t * far, 0], ["*t*₀", "*t*₁", "", ""][i], "s", "mark");
  s.text([far, 0], "*D*", "s");
  s.text([0, 0.85], "*V T*", "w");
  s.text([0.45 * far, 1.45], "*L* is *s* times the area", "e");
}

export const diagrams = [{
  name: "ray", width: 640, height: 426, draw(s) {
    space(s.panel({ origin: [14, 282], unit: 40 }));
    curve(s.panel({ origin: [60, 398], unit: 38 }));
  },
  title: "The lit parts of a ray through dusty air",
  text: "A lamp over two boards; their shadows hang in the air. The ray from the eye to the ground enters a shadow at t0, leaves it at t1, and enters and leaves another one. Below: " +
    "what arrives at the eye from each place of the ray falls with the distance and is nothing in a shadow. The light that the dust sends is the area under the lit parts.",
}];
