// The diagram of lab 03: one point in shadow and one in the light, with the two depths that are compared.
import { add, along, fall, scale, sub, unit } from "../../grader/site/geometry.mjs";

const lamp = [2.6, 6.2], point = [6.6, 0], other = [10.2, 0], eye = [13.2, 4.4];
const low = [4, 2.1], high = [5.5, 2.9]; // corners of the caster

function draw(s) {
  const corners = [low, [high[0], low[1]], high, [low[0], high[1]]];
  const ends = corners.map((corner) => fall(lamp, corner)).sort((a, b) => a[0] - b[0]);
  s.area([low, ends[0], ends[3], high], "dark");
  // The map lies before the lamp, which looks along the ray to the point.
  const axis = unit(sub(point, lamp)), side = [-axis[1], axis[0]], middle = add(lamp, scale(axis, 1.1));
  const texel = (i) => add(middle, scale(side, i * 0.2));
  s.line(lamp, fall(lamp, texel(-4.5)), "beam");
  s.line(lamp, along(lamp, texel(4.5), 5.6), "beam");
  s.line(texel(-4.5), texel(4.5), "line");
  for (let i = -4.5; i < 5; i++) s.line(add(texel(i), scale(axis, 0.09)), sub(texel(i), scale(axis, 0.09)), "line");
  s.line(texel(-0.5), texel(0.5), "yellow");
  s.text(texel(4.5), "shadow map", "ne");
  s.line([0.4, 0], [14, 0], "surface");
  s.box(low, high, "solid");
  s.arrow(eye, point, "eye");
  s.arrow(eye, other, "eye");
  const nearest = fall(lamp, point, high[1]);
  s.line(lamp, nearest, "lamp");
  s.line(nearest, point, "dashed");
  s.arrow(lamp, other, "lamp");
  s.measure(lamp, nearest, "", -16);
  s.text(add(along(lamp, nearest, 0.62), scale(side, -0.5)), "*map*", "sw", "mark");
  s.measure(lamp, point, "", -50);
  s.text(add(along(lamp, point, 0.62), scale(side, -1.42)), "*m~z~*", "w", "mark");
  s.dot(nearest, "mark");
  s.dot(point, "mark");
  s.dot(other, "lamp");
  s.text(point, "dark: *map* < *m~z~*", "se");
  s.text(other, "lit: *map* = *m~z~*", "se");
  s.light(lamp, "lamp", "w");
  s.eye(eye, along(point, other, 0.5), "eye");
}

export const diagrams = [{
  name: "passes", width: 600, height: 330, unit: 40, origin: [20, 290], draw,
  title: "Two passes and two depths",
  text: "A lamp looks down at a floor past a box. Each texel of the map before it keeps the depth of the nearest surface on its ray. " +
    "A point of the floor that the eye sees under the box is farther from the lamp than the box, so it is dark. Another point is just what the lamp sees: it is lit.",
}];
