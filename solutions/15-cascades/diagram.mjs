// The diagrams of lab 15: slices and their spheres, and a map on a fixed grid.
const k = 0.32, ends = [1, 2, 4, 8];
const sphere = (n, f) => {
  const center = Math.min(((f + n) * (1 + k * k)) / 2, f);
  return [center, Math.hypot(f - center, f * k)];
};

export const diagrams = [{
  name: "slices", width: 660, height: 340, draw(s) {
    const panel = s.panel({ origin: [40, 170], unit: 52 });
    panel.line([0, 0], [9, 0], "dashed");
    panel.line([0, 0], [8, 8 * k], "line");
    panel.line([0, 0], [8, -8 * k], "line");
    for (const end of ends) panel.line([end, end * k], [end, -end * k], "line");
    for (let i = 1; i < ends.length; i++) {
      const [center, radius] = sphere(ends[i - 1], ends[i]);
      panel.circle([center, 0], radius, "mark");
      panel.dot([center, 0], "mark", 3);
    }
    panel.eye([0, 0], [1, 0], "eye", "n");
    panel.text([1, -k], "*n*", "s");
    panel.text([8, -8 * k], "*f*", "s");
    panel.text([2, -2 * k], "*C*₁", "s");
    panel.text([4, -4 * k], "*C*₂", "s");
  },
  title: "Slices and their spheres",
  text: "What the camera sees, cut into three slices by borders at distances that double. Around each slice lies the smallest sphere through its corners; its centre lies on the camera's axis.",
}, {
  name: "grid", width: 660, height: 230, draw(s) {
    const left = s.panel({ origin: [50, 190], unit: 26 });
    for (let i = 0; i <= 10; i++) {
      left.line([i, 0], [i, 6], "faint");
      if (i <= 6) left.line([0, i], [10, i], "faint");
    }
    left.area([[1, 1], [6, 1], [6, 5], [1, 5]], "half");
    left.area([[3, 1], [8, 1], [8, 5], [3, 5]], "half");
    left.arrow([3.5, 3], [5.5, 3], "mark");
    left.text([5, 6], "by whole texels", "n");
    const right = s.panel({ origin: [370, 190], unit: 26 });
    for (let i = 0; i <= 5; i++) {
      right.line([1 + i, 1], [1 + i, 5], "faint");
      right.line([3.4 + i, 1.3], [3.4 + i, 5.3], "line");
      if (i <= 4) right.line([1, 1 + i], [6, 1 + i], "faint");
      if (i <= 4) right.line([3.4, 1.3 + i], [8.4, 1.3 + i], "line");
    }
    right.arrow([3.5, 3], [5.9, 3.3], "mark");
    right.text([5, 6], "by any distance", "n");
  },
  title: "A map that moves",
  text: "Left: a map that moves by whole texels keeps its texels where they were in the world. Right: after any other step all texels lie elsewhere, and so do the borders of shadows.",
}];
