// What goes wrong, of all labs on one page: their pictures side by side, each with what it shows.

const section = /<h2 id="what-goes-wrong[^"]*">[^]*?<\/h2>([^]*?)(?=<h2 |$)/;

export function gallery(labs) {
  const parts = labs.flatMap(({ file, label, html }) => {
    const found = html.match(section);
    return found ? [`<h2 id="${file.slice(0, 2)}">Lab ${label}</h2>\n${found[1].replace(/ id="[^"]*"/g, "")}`
      + `<p><a href="${file}">The handout of lab ${label}</a></p>\n`] : [];
  });
  return `<h1>What goes wrong, and how it looks</h1>
<p>A wrong picture seldom says what is wrong. Here are those of all labs: find the one that looks like yours.</p>
${parts.join("")}`;
}
