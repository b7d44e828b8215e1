// Looks for all words of the question in each section; those with a word in their heading come first.
const box = document.getElementById("q"), said = document.getElementById("said"), found = document.getElementById("found");
const MOST = 40, AROUND = 80;
for (const entry of index) entry.push(entry[2].toLowerCase(), `${entry[1]} ${entry[2]} ${entry[3]}`.toLowerCase());

function rank([, , , , heading, all], words) {
  if (!words.every((word) => all.includes(word))) return 0;
  return 1 + 4 * words.filter((word) => heading.includes(word)).length;
}

// The text around the first word that stands in it, with all words marked.
function excerpt(text, words) {
  const lower = text.toLowerCase();
  const at = Math.min(...words.map((word) => lower.indexOf(word)).map((n) => (n < 0 ? Infinity : n)));
  const from = at === Infinity ? 0 : Math.max(0, at - AROUND);
  const part = text.slice(from, from + 3 * AROUND);
  const line = document.createElement("p");
  line.append(from ? "... " : "");
  const pattern = new RegExp(`(${words.map((word) => word.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")).join("|")})`, "gi");
  for (const [n, piece] of part.split(pattern).entries()) {
    if (n % 2) line.append(Object.assign(document.createElement("mark"), { textContent: piece }));
    else line.append(piece);
  }
  return line;
}

function show() {
  const words = box.value.toLowerCase().split(/\s+/).filter(Boolean);
  const hits = words.length ? index.map((entry) => [rank(entry, words), entry]).filter(([points]) => points) : [];
  hits.sort((a, b) => b[0] - a[0]); // of one rank they stay in the order of the pages
  said.textContent = !words.length ? "Type a word, for instance bias." : `${hits.length} ${hits.length === 1 ? "section" : "sections"}`
    + (hits.length > MOST ? `; the first ${MOST} are shown` : "");
  found.replaceChildren(...hits.slice(0, MOST).map(([, [address, page, heading, text]]) => {
    const item = document.createElement("li"), link = document.createElement("a");
    link.href = address;
    link.textContent = page === heading ? page : `${page}: ${heading}`;
    item.append(link, excerpt(text, words));
    return item;
  }));
}

box.value = new URLSearchParams(location.search).get("q") ?? "";
box.addEventListener("input", show);
show();
