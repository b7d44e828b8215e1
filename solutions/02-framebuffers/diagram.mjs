// The diagrams of lab 02: three framebuffers with what is attached to them, and the curve of the stored depth.
import { range } from "../../grader/site/geometry.mjs";

function target(s, x, title, lines) {
  s.box([x, 40], [x + 186, 192], "open");
  s.text([x + 93, 204], title, "c");
  lines.forEach(([name, what, kind], i) => {
    const top = 180 - i * 68;
    s.box([x + 12, top - 56], [x + 174, top], kind);
    s.text([x + 93, top - 20], name, "c");
    s.text([x + 93, top - 40], what, "c", "small");
  });
}

function draw(s) {
  target(s, 12, "a view in colour", [["colour 0", "a texture", "lit"], ["depth", "a renderbuffer", "half"]]);
  target(s, 227, "a view in depths", [["no colour", "GL_NONE", "faint"], ["depth", "a texture", "half"]]);
  target(s, 442, "frame->framebuffer", [["colour 0", "the picture", "lit"], ["depth", "of the picture", "half"]]);
  s.path([[105, 40], [105, 22], [495, 22]], "lamp");
  s.arrow([495, 22], [495, 38], "lamp");
  s.path([[320, 40], [320, 22]], "lamp");
  s.text([312, 22], "textures are looked up while the picture is drawn", "s", "lamp");
}

function curve(s) {  const near = 1, far = 8, tall = 1.8; // what is drawn for the depth 1
  const depth = (d) => ((far + near) / (far - near) - (2 * far * near) / ((far - near) * d) + 1) / 2;
  const half = (2 * near * far) / (near + far), ways = range(57).map((i) => near + ((far - near) * i) / 56);
  s.arrow([0, 0], [8.9, 0], "line");
  s.arrow([0, 0], [0, 1.2 * tall], "line");
  s.path([[0, tall], [far, tall], [far, 0]], "dashed");
  s.path(ways.map((d) => [d, tall * depth(d)]), "eye");
  s.path([[half, 0], [half, tall / 2], [0, tall / 2]], "dashed");
  s.dot([half, tall / 2], "mark");
  s.text([half, 0.46 * tall], "half of all depths lie before *d* = 2*nf*/(*n* + *f*)", "e", "mark");
  s.text([8.7, 0], "*d*", "n");
  s.text([near, 0], "*n*", "s");
  s.text([far, 0], "*f*", "s");
  s.text([0, tall], "depth 1", "ne");
}

export const diagrams = [{
  name: "attachments", width: 640, height: 244, origin: [0, 238], unit: 1, draw,
  title: "Framebuffers and their attachments",
  text: "Three framebuffers. The first has a colour texture and a depth renderbuffer. The second has no colour and a depth texture. The third is the picture. " +
    "The two textures are looked up while the picture is drawn.",
}, {
  name: "depths", width: 640, height: 190, unit: 66, origin: [26, 160], draw: curve,
  title: "The depth that is stored, over the distance",
  text: "A curve that begins at 0 for the distance n, is 0.5 at the distance 2nf/(n + f), and comes slowly to 1 at the distance f.",
}];
