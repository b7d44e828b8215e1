// The diagram of lab @ID@: a lamp, a surface, and the ray between them.
const lamp = [1.5, 2.6], point = [4.5, 0];

export const diagrams = [{
  name: "lamp-and-surface", width: 640, height: 300, draw(s) {
    const panel = s.panel({ origin: [60, 240], unit: 75 });
    panel.line([0, 0], [7, 0], "line");
    panel.line(lamp, point, "lamp");
    panel.dot(lamp, "lamp");
    panel.dot(point, "mark");
    panel.text(lamp, "the lamp", "n");
    panel.text(point, "a point", "s");
  },
  title: "A lamp over a surface",
  text: "A lamp, a surface below it, and the ray from the lamp to one of its points.",
}];
