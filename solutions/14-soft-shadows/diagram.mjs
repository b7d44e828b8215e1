// The diagram of lab 14: the lamp seen through a point of the receiver.
const lamp = 1.1, blocker = 1.6, receiver = 3.2; // half the side, and distances below the lamp
const at = (x, distance) => [x, 3.2 - distance];
const half = (lamp * (receiver - blocker)) / receiver;

function rays(s) {
  s.area([at(-lamp, 0), at(lamp, 0), at(0, receiver)], "half");
  s.line(at(-lamp, 0), at(0, receiver), "dashed");
  s.line(at(lamp, 0), at(0, receiver), "dashed");
  s.line(at(-lamp, 0), at(lamp, 0), "lamp");
  s.text(at(0, 0), "lamp, *S*", "n", "lamp");
}

export const diagrams = [{
  name: "kernel", width: 560, height: 330, draw(s) {
    const p = s.panel({ origin: [230, 300], unit: 80 });
    rays(p);
    p.line(at(-2.4, receiver), at(3.4, receiver), "surface");
    p.text(at(2.6, receiver), "receiver", "s");
    p.line(at(-2.2, blocker), at(0, blocker), "surface");
    p.text(at(-2.2, blocker), "blocker", "n");
    p.line(at(-half, blocker), at(half, blocker), "mark");
    p.text(at(half, blocker), "*S* (*r* - *b*) / *r*", "e", "mark");
    p.dot(at(0, receiver), "eye", 5);
    p.text(at(0, receiver), "point", "s", "eye");
    for (const [x, distance, name] of [[2.6, blocker, "*b*"], [3.1, receiver, "*r*"]]) {
      p.arrow(at(x, 0), at(x, distance), "faint");
      p.text(at(x, distance / 2), name, "e");
    }
  },
  title: "The kernel is the lamp seen through the point",
  text: "A lamp of side S above, a receiver at the distance r below. The rays from the lamp to a point of the receiver form a triangle. At the distance b, where a blocker " +
    "ends, it is S (r - b) / r wide: that is the kernel. The blocker covers half of it, so half of the lamp is hidden.",
}];
