// The diagram of lab 05: a box of taps at an edge, the weights of three linear comparisons, and the ramps they make.
import { along, meet, range, sub, cross } from "../../grader/site/geometry.mjs";

const from = [2.1, 0], to = [4.3, 6]; // the edge of the shadow over the texels; what is left of it is dark
const isDark = (point) => cross(sub(to, from), sub(point, from)) > 0;

function taps(s) {
  for (const x of range(7))
    for (const y of range(6)) if (isDark([x + 0.5, y + 0.5])) s.box([x, y], [x + 1, y + 1], "half");
  for (const x of range(8)) s.line([x, 0], [x, 6], "faint");
  for (const y of range(7)) s.line([0, y], [7, y], "faint");
  s.line(from, to, "line");
  const point = [3.7, 3.3], around = range(9).map((i) => [point[0] + (i % 3) - 1, point[1] + Math.floor(i / 3) - 1]);
  const answers = around.map((tap) => !isDark(tap.map((x) => Math.floor(x) + 0.5)));
  s.box([2, 2], [5, 5], "mark");
  around.forEach((tap, i) => s.dot(tap, answers[i] ? "lamp" : "", 4.5));
  s.circle(point, 0.24, "mark");
  s.text([3.5, 0], `3 × 3: ${answers.filter(Boolean).length} of 9 say lit`, "s");
  s.text(along(from, to, meet(from, to, [0, 6], [1, 6])), "the edge", "n");
}

function weights(s) {
  const f = 0.3, heights = [(1 - f) / 3, 1 / 3, 1 / 3, f / 3], names = ["1 − *f*", "1", "1", "*f*"];
  heights.forEach((height, i) => {
    s.box([i, 0], [i + 1, 5.4 * height], "half");
    s.text([i + 0.5, 5.4 * height], names[i], "n");
  });
  s.line([0, 0], [4, 0], "line");
  for (const i of range(5)) s.line([i, -0.12], [i, 0.12], "line");
  for (const i of range(3)) s.dot([0.5 + f + i, 0], "mark"); // lookups, one texel apart; f counts from a texel's middle
  s.text([2, 0], "three linear comparisons, a third each", "s");
}

function ramps(s) {
  s.path([[0, 0], [3, 0], [3, 1], [6.5, 1]], "dashed");
  s.path([[0, 0], [1.5, 0], [4.5, 1], [6.5, 1]], "lamp");
  s.measure([1.5, -0.2], [4.5, -0.2], "*w* = 2*k* + 1 texels", 0, "s");
  s.text([6.5, 1], "*V* = 1", "e");
  s.text([0, 0], "0", "w");
}

export const diagrams = [{
  name: "kernels", width: 640, height: 310, draw(s) {
    taps(s.panel({ origin: [22, 256], unit: 36 }));
    weights(s.panel({ origin: [352, 130], unit: 50 }));
    ramps(s.panel({ origin: [332, 268], unit: 36 }));
  },
  title: "Kernels at a shadow's edge",
  text: "Left: nine taps around a point, one in each of three by three texels; those that lie in lit texels are counted. Upper right: three linear comparisons, " +
    "one texel apart, ask four texels with the weights 1 - f, 1, 1 and f, a third each. Lower right: a box of 2k + 1 linear comparisons turns a step into a ramp, 2k + 1 texels wide.",
}];
