// The diagram of lab 04: texels of a map over a tilted surface.
import { add, radians, range, scale } from "../../grader/site/geometry.mjs";

const s0 = 190, theta = radians(28), slope = Math.tan(theta); // a texel's width in pixels; the surface sinks to the right
const surface = (x) => [x, -slope * x];

function draw(s) {
  const border = 1.5 * s0;
  for (const i of range(4)) s.line([-border + i * s0, 148], [-border + i * s0, -155], "dashed");
  for (const i of range(3)) {
    const middle = (i - 1) * s0, end = middle + s0 / 2, stored = surface(middle)[1];
    s.area([surface(middle), [end, stored], surface(end)], "wrong");
    s.line([middle - s0 / 2, stored], [end, stored], "lamp");
  }
  s.line(surface(-border), surface(border), "surface");
  for (const i of range(3)) {
    const middle = (i - 1) * s0;
    s.line(surface(middle), surface(middle + s0 / 2), "blue");
    if (i) s.arrow([middle, 135], surface(middle), "lamp");
    s.dot(surface(middle), "lamp", 4);
  }
  const foot = surface(-62), normal = [Math.sin(theta), Math.cos(theta)];
  const [n, l] = [add(foot, scale(normal, 92)), add(foot, [0, 92])];
  s.arrow(foot, n, "line");
  s.arrow(foot, l, "line");
  s.text(n, "*N*", "e");
  s.text(l, "*L*", "w");
  s.angle(foot, l, n, 56, "*θ*");
  s.measure([-s0 / 2, 146], [s0 / 2, 146], "a texel: *s*", 0, "n");
  s.measure([border + 8, surface(border)[1]], [border + 8, surface(s0)[1]], "");
  s.text([border + 8, (surface(border)[1] + surface(s0)[1]) / 2], "*b*₀", "e", "mark");
  s.text([-border + 4, -84], "orange: the stored depth, one for the whole texel", "e", "lamp", -10);
  s.text([-border + 4, -108], "blue: behind it, so dark by mistake", "e", "eye", -10);
}

export const diagrams = [{
  name: "texel", width: 640, height: 350, origin: [305, 185], unit: 1, draw,
  title: "Why a tilted surface shadows itself",
  text: "Light falls from above onto a surface that is tilted by the angle theta between its normal N and the direction L to the light. " +
    "The map keeps one depth for each texel of width s, that in its middle. Half of the surface under the texel lies deeper, at its border by b0.",
}];
