// The diagrams of lab 10: a caster pressed flat by a lamp and by a sun; a wide lamp.
import { add, fall } from "../../grader/site/geometry.mjs";

const board = [[2.9, 2.6], [4.1, 2.2]];

function heights(s) {
  const lamp = [1.7, 4.9], shadow = board.map((point) => fall(lamp, point));
  s.area([...board, shadow[1], shadow[0]], "half");
  s.line([0, 0], [7, 0], "surface");
  board.forEach((point, i) => s.arrow(lamp, shadow[i], "lamp"));
  s.line(...board, "surface");
  s.line(...shadow, "shade");
  s.measure(lamp, [lamp[0], 0], "", -44);
  s.text([0.7, 2.6], "*P·L*", "w", "mark", -2);
  s.measure(board[0], [board[0][0], 0], "", 0);
  s.text([2.9, 1.1], "*P·v*", "w", "mark");
  board.forEach((point) => s.dot(point));
  s.dot(shadow[0]);
  s.dot(shadow[1]);
  s.text(board[0], "*v*", "nw");
  s.text(shadow[0], "*v*′", "s");
  s.text([7, 0], "*P*", "n");
  s.text([3.6, 2.4], "its lower side: own shadow", "e", "quiet", 16);
  s.light(lamp, "*L* = (*l*, 1)", "e");
}

function sun(s) {
  const way = [1, -1.7], shadow = board.map((point) => fall(point, add(point, way)));
  const start = board.map(([x, y]) => [x - (4.9 - y) / 1.7, 4.9]);
  s.area([...board, shadow[1], shadow[0]], "half");
  s.line([0.4, 0], [6.6, 0], "surface");
  board.forEach((point, i) => s.arrow(start[i], shadow[i], "lamp"));
  s.line(...board, "surface");
  s.line(...shadow, "shade");
  s.text([2.8, 4.7], "sun: *L* = (*l*, 0)", "e", "lamp");
}

function wide(s) {
  const [side, high, caster, low] = [1.1, 5, 2.2, 2.3], middle = 6.6;
  const lamp = [-1, 1].map((i) => [middle + (i * side) / 2, high]), plate = [-1, 1].map((i) => [middle + (i * caster) / 2, low]);
  const inner = [fall(lamp[0], plate[0])[0], fall(lamp[1], plate[1])[0]], outer = [fall(lamp[1], plate[0])[0], fall(lamp[0], plate[1])[0]];
  s.area([plate[0], plate[1], [outer[1], 0], [outer[0], 0]], "half");
  s.area([plate[0], plate[1], [inner[1], 0], [inner[0], 0]], "half");
  s.line([0, 0], [14.2, 0], "surface");
  for (const end of lamp) for (const edge of plate) s.line(end, fall(end, edge), "lamp");
  s.line(...lamp, "yellow");
  s.line(...plate, "surface");
  s.line([inner[0], 0], [inner[1], 0], "shade");
  s.text(lamp[1], "a wide lamp: side *s*, height *H*", "e", "lamp");
  s.text(plate[1], "side *a*, height *h*", "e");
  s.measure([outer[0], -0.28], [inner[0], -0.28], "");
  s.measure([inner[0], -0.28], [inner[1], -0.28], "umbra", 0, "s", "line");
  s.text([outer[0], -0.28], "penumbra", "w", "mark");
  s.measure([inner[1], -0.28], [outer[1], -0.28], "");
  s.text([outer[1], -0.28], "penumbra *s h*/(*H* − *h*)", "e", "mark");
}

export const diagrams = [{
  name: "lamp", width: 640, height: 536, draw(s) {
    heights(s.panel({ origin: [46, 236], unit: 42 }));
    sun(s.panel({ origin: [348, 236], unit: 42 }));
    wide(s.panel({ origin: [22, 490], unit: 42 }));
  },
  title: "Shadows on a plane, from the side",
  text: "Upper left: a board at the height P·v over the plane, a lamp at the height P·L; lines from the lamp through the board's ends v meet the plane in v′. Upper right: the same with " +
    "a sun, whose lines are parallel. Below: a wide lamp; in the umbra no part of it is seen, in the penumbra a part of it.",
}];
