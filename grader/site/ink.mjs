// What a drawing looks like, in light and in dark, and the drawing as a file.
import { words } from "./sketch.mjs";

export const palettes = {
  light: { ink: "#22201d", quiet: "#625d56", paper: "#f7f5ef", grey: "#b9b3a8", night: "#5d6470", dark: 0.4, half: 0.2, lamp: "#a86400", glow: "#ffd98a",
    eye: "#1f5fa8", mark: "#a8321f", blue: "#2b6fd0", yellow: "#e0a800" },
  dark: { ink: "#e6e2db", quiet: "#aaa39a", paper: "#2b2926", grey: "#777168", night: "#000000", dark: 0.55, half: 0.36, lamp: "#f0b850", glow: "#c4923a",
    eye: "#82b7f5", mark: "#ff9c86", blue: "#5a9bff", yellow: "#ffd23f" },
};

// What the kinds look like, as CSS, within what `scope` selects.
export function rules(p, scope = "") {
  const style = {
    ".card": `fill:${p.paper}`,
    text: `fill:${p.ink};font:16px system-ui,"Segoe UI","Noto Sans","Helvetica Neue",Arial,sans-serif;paint-order:stroke;stroke:${p.paper};stroke-width:4px;stroke-linejoin:round`,
    ".v": "font-style:italic;font-family:Georgia,\"Noto Serif\",serif", ".low": "font-size:11px",
    "path,circle": "fill:none;stroke-width:1.6;stroke-linejoin:round;stroke-linecap:round",
    ".line": `stroke:${p.ink}`, ".surface": `stroke:${p.ink};stroke-width:3.5`, ".faint": `stroke:${p.grey}`,
    ".dashed": `stroke:${p.quiet};stroke-dasharray:5 4`, ".solid": `fill:${p.grey};stroke:${p.ink}`,
    ".lamp": `stroke:${p.lamp};stroke-width:2`, ".beam": `stroke:${p.lamp};stroke-dasharray:6 4`, ".lit": `fill:${p.glow};fill-opacity:.55`,
    ".eye": `stroke:${p.eye};stroke-width:2`, ".mark": `stroke:${p.mark};stroke-width:2`,
    ".dark": `fill:${p.night};fill-opacity:${p.dark}`, ".half": `fill:${p.night};fill-opacity:${p.half}`,
    ".blue": `stroke:${p.blue};stroke-width:6;stroke-linecap:butt`, ".yellow": `stroke:${p.yellow};stroke-width:6;stroke-linecap:butt`,
    ".shade": `stroke:${p.night};stroke-opacity:.65;stroke-width:7;stroke-linecap:butt`,
    ".wrong": `fill:${p.blue};fill-opacity:.5`, ".open": `fill:${p.paper};stroke:${p.ink}`,
    ".dot": `fill:${p.ink}`, ".dot.mark": `fill:${p.mark};stroke:none`, ".dot.eye": `fill:${p.eye};stroke:none`, ".dot.lamp": `fill:${p.lamp};stroke:none`,
    ".dot.blue": `fill:${p.blue};stroke:none`, ".dot.yellow": `fill:${p.yellow};stroke:none`,
    ...Object.fromEntries(["quiet", "mark", "lamp", "eye"].map((kind) => [`text.${kind}`, `fill:${p[kind]};stroke:${p.paper};stroke-width:4px`])),
    "text.small": `font-size:14px;fill:${p.quiet}`,
  };
  return Object.entries(style).map(([names, how]) => `${names.split(",").map((name) => scope + name).join()}{${how}}`).join("\n");
}

// The drawing as a file.
export function file({ width, height, title, text }, parts) {
  const style = `${rules(palettes.light)}\n@media screen and (prefers-color-scheme:dark){\n${rules(palettes.dark)}\n}`;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" role="img" aria-labelledby="t d">
<title id="t">${words(title)}</title>
<desc id="d">${words(text)}</desc>
<style>
${style}
</style>
<rect class="card" width="${width}" height="${height}" rx="8"/>
${parts.join("\n")}
</svg>
`;
}
