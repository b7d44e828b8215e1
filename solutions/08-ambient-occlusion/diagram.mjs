// The diagram of lab 08: the hemisphere over a point before a wall, cut through the middle.
import { meet, range, scale } from "../../grader/site/geometry.mjs";

const height = 1.25, distance = 0.9, count = 16; // of the wall; rays

function draw(s) {
  const rays = range(count).map((i) => (2 * (i + 0.5)) / count - 1).map((x) => [x, Math.sqrt(1 - x * x)]);
  const hits = rays.map(([x, y]) => x > 0 && (y / x) * distance < height);
  s.line([-1.4, 0], [2.25, 0], "surface");
  s.line([distance, 0], [distance, height], "surface");
  s.path(range(65).map((i) => [Math.cos((i * Math.PI) / 64), Math.sin((i * Math.PI) / 64)]), "dashed");
  rays.forEach((ray, i) => {
    s.line([ray[0], 0], ray, "faint");
    const wall = hits[i] && ray[0] > distance; // the wall stands within the hemisphere
    s.arrow([0, 0], wall ? scale(ray, meet([0, 0], ray, [distance, 0], [distance, height])) : ray, hits[i] ? "mark" : "lamp");
    s.dot([ray[0], 0], hits[i] ? "mark" : "lamp", 4);
  });
  s.line([0, 0], [distance, height], "dashed");
  s.arrow([0, 0], [0, 1.28], "line");
  s.text([0, 1.28], "*n*", "e");
  s.measure([0, 0], [distance, 0], "*x*", -34, "s");
  s.measure([distance, height], [distance, 0], "", 30);
  s.text([distance + 0.22, height / 2], "*h*", "e", "mark");
  s.text([-1.36, 1.36], "points spread evenly below,", "e", "", -8);
  s.text([-1.36, 1.24], "lifted onto the hemisphere", "e", "", -8);
  s.text([distance + 0.24, 1.2], `${hits.filter(Boolean).length} of ${count} rays hit`, "e");
  s.text([distance + 0.24, 1.06], "(1 − *x*/√(*x*² + *h*²))/2", "e", "small");
  s.text([distance + 0.24, 0.95], `= ${((1 - distance / Math.hypot(distance, height)) / 2).toFixed(2)}`, "e", "small");
}

export const diagrams = [{
  name: "hemisphere", width: 640, height: 320, unit: 172, origin: [246, 252], draw,
  title: "Rays over the hemisphere, before a wall",
  text: "A point on the floor stands before a wall of the height h at the distance x. Points that lie evenly over the disc below are lifted onto the hemisphere: so more rays " +
    "go where the cosine is larger. Some of the rays hit the wall; their share is the occlusion.",
}];
