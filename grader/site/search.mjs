// A page that searches all others, offline: its index is in the page, and a script of ours looks through it.
const text = (html) => html
  .replace(/<annotation[^]*?<\/annotation>/g, "").replace(/<(style|details|svg|script)\b[^]*?<\/\1>/g, " ")
  .replace(/<[^>]*>/g, " ").replace(/&lt;/g, "<").replace(/&gt;/g, ">").replace(/&quot;/g, '"').replace(/&amp;/g, "&")
  .replace(/\s+/g, " ").trim();

// An entry for each section: [address, page, heading, words]. What is folded up (answers) is left out.
function entries({ file, title, html }) {
  const parts = html.split(/(?=<h[23] id=")/);
  return parts.map((part) => {
    const head = part.match(/^<h[23] id="([^"]*)">([^]*?)<\/h[23]>/);
    return [head ? `${file}#${head[1]}` : file, title, head ? text(head[2]) : title, text(part.replace(/^<h[1-3][^]*?<\/h[1-3]>/, ""))];
  });
}

// The page's HTML and its script.
export function search(pages, script) {
  // "<" is written otherwise, so that no text ends the script.
  const index = JSON.stringify(pages.flatMap(entries)).replace(/</g, "\\u003c");
  const code = `"use strict";\nconst index = ${index};\n${script}`;
  const html = `<h1>Search</h1>
<form class="search" role="search" action="search.html"><label for="q">In all pages</label> <input type="search" id="q" name="q" autocomplete="off"></form>
<p id="said" role="status">Without scripts this page finds nothing.</p>
<ol id="found"></ol>
<script>${code}</script>
`;
  return { html, scripts: [code] };
}
