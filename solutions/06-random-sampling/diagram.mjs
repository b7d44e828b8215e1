// The diagram of lab 06: 32 samples in the unit square, and the same in the disc.
import { random, range } from "../../grader/site/geometry.mjs";

const columns = 4, rows = 8, next = random(6);
const samples = range(columns * rows).map((k) => {
  const [x, y] = [next() - 0.5, next() - 0.5];
  return [((k % columns) + 0.5 + x) / columns, (rows - 1 - Math.floor(k / columns) + 0.5 + y) / rows];
});
const kind = (k) => (k < 8 ? "mark" : "eye");

function square(s) {
  for (const i of range(columns + 1)) s.line([i / columns, 0], [i / columns, 1], "faint");
  for (const i of range(rows + 1)) s.line([0, i / rows], [1, i / rows], "faint");
  samples.forEach((sample, k) => s.dot(sample, kind(k), 4.5));
  s.text([0.5, 0], "*u*", "s");
  s.text([0, 0.5], "*v*", "w");
  s.text([0, 0], "0", "w");
  s.text([0, 1], "1", "w");
  s.text([1, 0], "1", "s");
  s.text([1, 0.875], "the first eight", "e", "mark");
}

function disc(s) {
  const at = ([u, v]) => [Math.sqrt(v) * Math.cos(2 * Math.PI * u), Math.sqrt(v) * Math.sin(2 * Math.PI * u)];
  for (const i of range(rows)) s.circle([0, 0], Math.sqrt((i + 1) / rows), "faint");
  for (const i of range(columns)) s.line([0, 0], at([i / columns, 1]), "faint");
  s.circle([0, 0], Math.sqrt(6 / rows), "dashed");
  samples.forEach((sample, k) => s.dot(at(sample), kind(k), 4.5));
  s.text([0, -1], "rings of equal area; dashed: 0.866", "s");
}

export const diagrams = [{
  name: "disc", width: 620, height: 300, draw(s) {
    square(s.panel({ origin: [36, 258], unit: 226 }));
    s.arrow([290, 145], [330, 145], "line");
    disc(s.panel({ origin: [466, 145], unit: 112 }));
  },
  title: "From the square to the disc",
  text: "Left the unit square, cut into 4 columns and 8 rows: in each cell one sample at a random place. Right the same samples in the disc: columns have become " +
    "sectors, rows rings of equal area. The first eight samples, of the two upper rows, lie between 0.866 and 1 of the radius.",
}];
