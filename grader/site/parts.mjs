// Parts of Markdown files: the sections of README.md, the rows of its table of labs, the rows of slides.md.

// The text before the first heading of the second level, and the sections: { head, body }.
export function sections(markdown) {
  const [before, ...rest] = markdown.split(/^## /m);
  return { before, parts: rest.map((text) => ({ head: text.slice(0, text.indexOf("\n")), body: text.slice(text.indexOf("\n")) })) };
}

// { what, needs, hours } of the lab with this handout; undefined when the table has no such row.
export function labRow(readme, source) {
  const row = readme.split("\n").find((line) => line.startsWith("| [") && line.includes(`](${source})`));
  const cells = row?.split("|").map((cell) => cell.trim());
  return cells && { what: cells[2], needs: cells[3], hours: cells[4] };
}

// Which slides a task follows, from the last column of slides.md: task -> ["000 10.3", ...], each once, in their order.
export function slidesOfTasks(slides) {
  const found = new Map();
  let lecture = "";
  for (const line of slides.split("\n")) {
    lecture = line.match(/^## .*\(lecture (\d+)\)/)?.[1] ?? (line.startsWith("## ") ? "" : lecture);
    const cells = lecture && line.startsWith("| ") ? line.split(/(?<!\\)\|/).map((cell) => cell.trim()) : [];
    for (const [, task] of (cells[4] ?? "").matchAll(/\[(\d+\.\d+)\]/g)) {
      if (!found.has(task)) found.set(task, new Set());
      found.get(task).add(`${lecture} ${cells[1]}`);
    }
  }
  return new Map([...found].map(([task, those]) => [task, [...those]]));
}
