// What a lab's page has beside its handout: the slides of each task, charts and rows of it.
import { escape } from "./pages.mjs";

// Behind each task of the table, the slides that it follows.
export function addSlides(html, slides) {
  return html.replace(/<tr>\s*<td>(\d+\.\d+)<\/td>\s*<td>([^]*?)<\/td>/g, (row, task) => {
    const those = slides.get(task);
    if (!those) return row;
    const chips = those.map((slide) => `<li>${escape(slide)}</li>`).join("");
    return row.replace(/<\/td>$/, `<ul class="chips" aria-label="Lecture and slide">${chips}</ul></td>`);
  });
}

// Links to what was measured with the lab, where it is there: [{ address, words }].
export function addMeasured(html, links) {
  if (!links.length) return html;
  const list = links.map(({ address, words }) => `<li><a href="${address}">${words}</a></li>`).join("\n");
  return `${html}<h2 id="measured">Measured with this lab</h2>\n<ul>\n${list}\n</ul>\n`;
}
