// A drawing in a plane, y up, as text of SVG: node makes the handouts' diagrams of it, a browser the site's figures.
// Points are [x, y] in units of the drawing. What a thing is like is told by a word, its kind: `rules` of
// ink.mjs has them all.
import { add, along, length, scale, sub, unit as direction } from "./geometry.mjs";

const number = (x) => String(Math.round(x * 10) / 10 + 0); // no -0
const entities = { "&": "&amp;", "<": "&lt;", ">": "&gt;" };
// Words between two asterisks are variables; those between two ~ stand lower.
export const words = (text) => text.replace(/[&<>]/g, (letter) => entities[letter]).replace(/\*([^*]+)\*/g, '<tspan class="v">$1</tspan>')
  .replace(/~([^~]+)~([^~]*)/g, (_, low, rest) => `<tspan class="low" dy="5">${low}</tspan>${rest && `<tspan dy="-5">${rest}</tspan>`}`);

// Which way words stand beside their point: anchor, and the shift in pixels.
const sides = {
  n: ["middle", 0, -10], s: ["middle", 0, 22], e: ["start", 10, 5], w: ["end", -10, 5], c: ["middle", 0, 5],
  ne: ["start", 8, -7], nw: ["end", -8, -7], se: ["start", 8, 18], sw: ["end", -8, 18],
};

// An empty drawing: `origin` is where (0, 0) lies, in pixels from the upper left corner; a unit has `unit` pixels.
export function sketch({ origin, unit }, parts = []) {
  const place = ([x, y]) => [origin[0] + unit * x, origin[1] - unit * y];
  const pixel = (point) => place(point).map(number).join(" ");
  const put = (text) => void parts.push(text);
  const pixels = (n) => n / unit;
  const s = {
    parts, unit, place,
    panel: (view) => sketch(view, parts), // another part of the same drawing, with coordinates of its own
    path: (points, kind = "line") => put(`<path class="${kind}" d="M${points.map(pixel).join("L")}"/>`),
    area: (points, kind = "solid") => put(`<path class="${kind}" d="M${points.map(pixel).join("L")}Z"/>`),
    line: (a, b, kind) => s.path([a, b], kind),
    box: ([x, y], [u, v], kind) => s.area([[x, y], [u, y], [u, v], [x, v]], kind),
    circle: (center, radius, kind = "line") => put(`<circle class="${kind}" cx="${number(place(center)[0])}" cy="${number(place(center)[1])}" r="${number(radius * unit)}"/>`),
    dot: (point, kind = "", size = 5) => s.circle(point, pixels(size), `dot ${kind}`.trim()),
    // An arrow from a to b; its head is filled.
    arrow(a, b, kind = "line") {
      const way = direction(sub(b, a)), side = [-way[1], way[0]], back = sub(b, scale(way, pixels(10)));
      s.line(a, back, kind);
      const name = { lamp: "lamp", eye: "eye", mark: "mark" }[kind] ?? "";
      s.area([b, add(back, scale(side, pixels(4.5))), sub(back, scale(side, pixels(4.5)))], `dot ${name}`.trim());
    },
    light(point, text, side = "e") {
      for (let i = 0; i < 8; i++) {
        const way = [Math.cos((i * Math.PI) / 4), Math.sin((i * Math.PI) / 4)];
        s.line(add(point, scale(way, pixels(10))), add(point, scale(way, pixels(15))), "lamp");
      }
      s.dot(point, "lamp", 7);
      if (text) s.text(point, text, side, "lamp", 8);
    },
    // An eye that looks towards a point.
    eye(point, toward, text, side = "n") {
      const way = direction(sub(toward, point)), half = 13, lid = 8;
      const curve = (sign) => Array.from({ length: 13 }, (_, i) => add(point, [pixels(half * (i / 6 - 1)), sign * pixels(lid * (1 - (i / 6 - 1) ** 2))]));
      s.area([...curve(1), ...curve(-1).reverse()], "open");
      s.area([...curve(1), ...curve(-1).reverse()], "eye");
      s.dot(add(point, scale(way, pixels(3))), "eye", 4.5);
      if (text) s.text(point, text, side, "eye", 8);
    },
    text(point, text, side = "e", kind = "", more = 0) {
      const [anchor, right, down] = sides[side], [x, y] = place(point);
      const at = [x + right + Math.sign(right) * more, y + down + Math.sign(down - 5) * (right ? 0 : more)].map(number);
      put(`<text${kind ? ` class="${kind}"` : ""} x="${at[0]}" y="${at[1]}" text-anchor="${anchor}">${words(text)}</text>`);
    },
    // How long it is from a to b: a line with two ends, moved `off` pixels to the left of the way from a to b.
    measure(a, b, text, off = 0, side = "n", kind = "mark") {
      const way = direction(sub(b, a)), up = [-way[1], way[0]], shift = scale(up, pixels(off)), tick = scale(up, pixels(5));
      const [c, d] = [add(a, shift), add(b, shift)];
      if (off) [[a, c], [b, d]].forEach(([from, to]) => s.line(from, to, "dashed"));
      s.line(c, d, kind);
      for (const end of [c, d]) s.line(sub(end, tick), add(end, tick), kind);
      if (text) s.text(along(c, d, 0.5), text, side, kind === "line" ? "" : kind);
    },
    // The angle at `center` from the direction of a to that of b, on the shorter way; `radius` in units.
    angle(center, a, b, radius, text, kind = "mark") {
      const [from, to] = [a, b].map((point) => Math.atan2(point[1] - center[1], point[0] - center[0]));
      const turn = Math.atan2(Math.sin(to - from), Math.cos(to - from));
      const on = (t, r = radius) => add(center, scale([Math.cos(from + turn * t), Math.sin(from + turn * t)], r));
      s.path(Array.from({ length: 17 }, (_, i) => on(i / 16)), kind);
      if (text) s.text(on(0.5, radius + pixels(14)), text, "c", kind);
    },
    length: (a, b) => length(sub(b, a)),
  };
  return s;
}
