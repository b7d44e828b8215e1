// The diagram of lab 16: what a filter sees at the border of an occluder, and what lies behind two.
export const diagrams = [{
  name: "bound", width: 620, height: 250, draw(s) {
    const left = s.panel({ origin: [40, 210], unit: 40 }), right = s.panel({ origin: [350, 210], unit: 40 });
    left.line([0, 0], [6, 0], "surface");
    left.text([1, 0], "receiver, *t*", "s");
    left.line([0, 2], [2.6, 2], "surface");
    left.text([0.7, 2], "occluder", "n");
    left.area([[1.6, 4.2], [4.6, 4.2], [4.6, 0], [1.6, 0]], "half");
    left.text([1.6, 4.2], "*q*", "n", "mark", 0);
    left.line([1.6, 4.2], [2.6, 4.2], "mark");
    left.text([3.9, 4.2], "filter", "n", "quiet");
    left.arrow([5.2, 2], [5.2, 0], "faint");
    left.text([5.2, 1], "*a*", "e");
    right.line([0, 0], [6, 0], "surface");
    right.text([1, 0], "receiver, dark", "s");
    right.line([0, 1.2], [5, 1.2], "surface");
    right.line([0, 3], [2.6, 3], "surface");
    right.area([[1.6, 4.2], [4.6, 4.2], [4.6, 0], [1.6, 0]], "half");
    right.line([1.6, 4.2], [2.6, 4.2], "mark");
    right.text([1.6, 4.2], "*q*", "n", "mark", 0);
    right.arrow([5.4, 3], [5.4, 1.2], "faint");
    right.text([5.4, 2.1], "*a*", "e");
    right.arrow([5.4, 1.2], [5.4, 0], "faint");
    right.text([5.4, 0.6], "*b*", "e");
  },
  title: "What two moments can tell",
  text: "Left: a filter at the border of one occluder, a above the receiver; a share q of it sees the occluder, the rest the receiver: two moments tell the share exactly. " +
    "Right: a lower occluder, b above the receiver, hides it wholly, and an upper one, a above the lower, covers the share q: the moments cannot tell this from some light on the receiver.",
}];
