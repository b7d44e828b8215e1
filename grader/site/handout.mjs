// What a lab's page has beside its handout: the slides of each task, the answer to its question, charts and rows of it.
import { existsSync, readFileSync } from "node:fs";
import { escape, prose } from "./pages.mjs";

const paragraphs = (texts) => texts.map((text) => `<p>${prose(text)}</p>`).join("\n");

// Behind each task of the table, the slides that it follows.
export function addSlides(html, slides) {
  return html.replace(/<tr>\s*<td>(\d+\.\d+)<\/td>\s*<td>([^]*?)<\/td>/g, (row, task) => {
    const those = slides.get(task);
    if (!those) return row;
    const chips = those.map((slide) => `<li>${escape(slide)}</li>`).join("");
    return row.replace(/<\/td>$/, `<ul class="chips" aria-label="Lecture and slide">${chips}</ul></td>`);
  });
}

// The answer stands behind the question, folded up: who reads on does not meet it.
export function addAnswer(html, folder) {
  const file = `${folder}/afterword.json`;
  if (!existsSync(file)) return html;
  const { idea, answer, "another way": way, try: tries } = JSON.parse(readFileSync(file, "utf8"));
  const folded = `<details class="answer"><summary>The answer, for when you have yours</summary>
${paragraphs(answer)}
<p>${prose(`The idea of the lab: ${idea}`)}</p>
<p>${prose(`Another way: ${way}`)}</p>
<p>To try in the window:</p>
<ul>${tries.map((text) => `<li>${prose(text)}</li>`).join("\n")}</ul>
</details>
`;
  const question = /(<h2 id="a-question">[^]*?)(?=<h2 |$)/;
  if (!question.test(html)) throw new Error(`${file}: its handout has no "## A question"; write one, or remove the file`);
  return html.replace(question, (whole) => whole + folded);
}

// Links to what was measured with the lab, where it is there: [{ address, words }].
export function addMeasured(html, links) {
  if (!links.length) return html;
  const list = links.map(({ address, words }) => `<li><a href="${address}">${words}</a></li>`).join("\n");
  return `${html}<h2 id="measured">Measured with this lab</h2>\n<ul>\n${list}\n</ul>\n`;
}
