// The diagram of lab 11: the cube of maps around a lamp, and a wide light cut into small lamps.
import { range, random, meet, along } from "../../grader/site/geometry.mjs";

function cube(s) {
  const point = [4.2, 1.15], lamp = [0, 0], face = 1.55;
  for (const [x, y] of [[1, 1], [1, -1], [-1, 1], [-1, -1]]) s.line(lamp, [x * 2.3, y * 2.3], "dashed");
  s.box([-face, -face], [face, face], "line");
  s.line([4.2, -2.2], [4.2, 2.2], "surface");
  s.arrow(lamp, point, "lamp");
  const texel = along(lamp, point, meet(lamp, point, [face, -1], [face, 1]));
  s.dot(texel, "lamp", 4);
  s.line([0, 0], [4.2, 0], "dashed");
  s.measure([0, 0], [4.2, 0], "", -14);
  s.text([2.75, -0.2], "*m*", "s", "mark");
  s.text(along(lamp, point, 0.66), "*d*", "n", "lamp");
  s.dot(point);
  s.text([face, -1.1], "+*x*", "e");
  s.text([-face, 0.9], "−*x*", "w");
  s.text([0, face], "+*y*", "n");
  s.text([0, -face], "−*y*", "s");
  s.text([4.2, 2.2], "one *m*, one depth", "n");
  s.light(lamp, "lamp", "w");
}

function cells(s) {
  const n = 4, next = random(11);
  s.box([0, 0], [1, 1], "lit");
  for (const i of range(n + 1)) s.line([0, i / n], [1, i / n], "faint");
  for (const i of range(n + 1)) s.line([i / n, 0], [i / n, 1], "faint");
  for (const i of range(n * n)) {
    const middle = [(i % n) + 0.5, Math.floor(i / n) + 0.5], moved = middle.map((x) => (x + 0.8 * (next() - 0.5)) / n);
    s.line(middle.map((x) => x / n), moved, "line");
    s.dot(moved, "lamp", 5);
  }
  s.measure([0, 1], [1, 1], "2*e*", 12, "n");
  s.text([0.5, 0], "*n* × *n* small lamps,", "s");
  s.text([0.5, -0.13], "each in its cell", "s");
}

export const diagrams = [{
  name: "cube", width: 640, height: 300, draw(s) {
    cube(s.panel({ origin: [136, 150], unit: 54 }));
    cells(s.panel({ origin: [432, 226], unit: 176 }));
  },
  title: "A cube of maps, and a wide light as small lamps",
  text: "Left, from the side: a lamp in the middle of its cube. The face +x sees a point; m is how far the point is along the axis of that face. All of a wall across this axis has the " +
    "same m, and so the same depth. Right: the square of a wide light, cut into 4 × 4 cells; in each stands a small lamp, moved from the middle by the jitter.",
}];
