// What goes wrong: wrong and right pictures under one slider, and the wrong ones of all labs on one page with the mistakes that the
// grader knows by name.
import { existsSync, readFileSync } from "node:fs";
import { escape } from "./pages.mjs";

const section = /<h2 id="what-goes-wrong[^"]*">[^]*?<\/h2>([^]*?)(?=<h2 |$)/;
const picture = '<img src="[^"]*" alt="([^"]*)"([^>]*)>';
const pair = new RegExp(`<p>(${picture})\\s+(${picture})</p>`, "g");

// Two pictures of one size in a paragraph lie upon each other, where a script runs. `script` is the slider's.
export function withSliders(html, script) {
  const all = html.replace(pair, (whole, first, left, size, second, right, otherSize) => size !== otherSize ? whole
    : `<figure class="pair"><div class="beside">${first}${second}</div>`
      + `<input type="range" min="0" max="100" value="50" hidden data-compare="${left.replace(/\|/g, "/")}|${right.replace(/\|/g, "/")}" aria-label="How much of the first picture is seen: ${left}">`
      + `<figcaption class="ends"><span>${left}</span><span>${right}</span></figcaption></figure>`);
  return all === html ? { html, scripts: [] } : { html: `${all}<script type="module">${script}</script>\n`, scripts: [script] };
}

// The mistakes of a lab that the grader tells by name: [{ name, task }], in the order of the tasks.
function mistakes(folder) {
  const file = `${folder}/mistakes.json`, order = (task) => Number(task.split(".")[1]);
  const all = existsSync(file) ? JSON.parse(readFileSync(file, "utf8")) : [];
  return all.sort((a, b) => order(a.task) - order(b.task));
}

function list(those) {
  const tasks = [...new Set(those.map(({ task }) => task))];
  const names = (task) => those.filter((mistake) => mistake.task === task).map(({ name }) => `<li>${escape(name)}</li>`).join("\n");
  return tasks.map((task) => `<h3>Task ${task}</h3>\n<ul>\n${names(task)}\n</ul>`).join("\n");
}

const known = (those) => `${those.length} mistakes that the grader knows by name`;

// Leads from the section of a handout to the list of its lab, where there is one.
export function addMistakes(html, lab, folder) {
  const those = mistakes(folder);
  if (!those.length || !section.test(html)) return html;
  const link = `<p><a href="wrong.html#${lab.slice(0, 2)}-mistakes">All ${known(those)}</a></p>\n`;
  return html.replace(section, (whole) => whole + link);
}

// The page of all labs: { lab, file, label, html, folder }, where `html` is that of the handout alone.
export function gallery(labs, script) {
  const parts = labs.flatMap(({ lab, file, label, html, folder }) => {
    const found = html.match(section), id = lab.slice(0, 2), those = mistakes(folder);
    const all = those.length ? `<details class="mistakes"><summary>The ${known(those)}</summary>\n<div id="${id}-mistakes">${list(those)}</div>\n</details>\n` : "";
    return found ? [`<h2 id="${id}">Lab ${label}</h2>\n${found[1].replace(/ id="[^"]*"/g, "")}${all}`
      + `<p><a href="${file}">The handout of lab ${label}</a></p>\n`] : [];
  });
  return withSliders(`<h1>What goes wrong, and how it looks</h1>
<p>A wrong picture seldom says what is wrong. Here are those of all labs: find the one that looks like yours. The slider goes from
the wrong picture to the right one. The lists below them are longer: when the grader finds one of these mistakes in your code, it says which, and gives a hint.</p>
${parts.join("")}`, script);
}
