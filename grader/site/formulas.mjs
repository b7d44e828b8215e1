// Formulas in Markdown: $...$ within a line, $$...$$ on lines of their own. They are taken out before the Markdown
// parser sees them (it would read _ and * in them) and put back as MathML. Code keeps its dollars.
import katex from "katex";

const token = (n) => `xFORMULAx${n}x`;
const tokens = /xFORMULAx(\d+)x/g;

// Either a fence of code, indented code, a span of code, a displayed formula or a formula within a line; the last three
// never across an empty line.
const pieces = new RegExp([
  /^(?<fence>```|~~~)[^]*?^\k<fence>[ ]*$/.source,
  /(?<=\n\n)(?: {4}.*(?:\n|$))+/.source,
  /(?<ticks>`+)(?!`)(?:(?!\n\n)[^])*?(?<!`)\k<ticks>(?!`)/.source,
  /\$\$(?<display>(?:(?!\n\n)[^])+?)\$\$/.source,
  /(?<![\\$\w])\$(?<line>[^\s$](?:(?:(?!\n\n)[^$])*?[^\s$])?)\$(?![\w$])/.source,
].join("|"), "gm");

// Returns the Markdown without formulas, and them.
export function takeFormulas(markdown) {
  const formulas = [];
  const text = markdown.replace(pieces, (whole, ...rest) => {
    const { display, line } = rest.at(-1);
    if (display === undefined && line === undefined) return whole;
    formulas.push({ tex: display ?? line, display: display !== undefined });
    return token(formulas.length - 1);
  });
  return { text, formulas };
}

// A formula within a line that may be wider than a phone, or than any page, can be scrolled by itself there, by keys, too.
const LONG = 32, LONGEST = 150; // letters of TeX

// One formula as MathML; throws with TeX's message when it is wrong.
export function mathml({ tex, display }) {
  const html = katex.renderToString(tex, { displayMode: display, output: "mathml", throwOnError: true, strict: "error" });
  return display || tex.length < LONG ? html : html.replace('<span class="katex">', `<span class="katex ${tex.length < LONGEST ? "long" : "longest"}" tabindex="0">`);
}

// Puts the formulas back into the parser's HTML. `where` names the file in an error.
export function putFormulas(html, formulas, where) {
  return html.replace(tokens, (_, n) => {
    try {
      return mathml(formulas[n]);
    } catch (error) {
      throw new Error(`${where}: the formula $${formulas[n].tex}$ is wrong: ${error.message}`);
    }
  });
}
