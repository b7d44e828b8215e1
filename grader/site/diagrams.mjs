// diagrams.mjs [--check] [NN]: draws the diagrams of the handouts, solutions/NN-name/*.svg, as solutions/NN-name/diagram.mjs
// describes them. --check writes nothing and prints what is not as described. Run in the project's folder, by `make diagrams`.
import { existsSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { file } from "./ink.mjs";
import { sketch } from "./sketch.mjs";

// The diagrams of a lab: each has a file's name, a size in pixels, a title and a text for who cannot see it, and draws itself.
async function drawn(folder) {
  const { diagrams } = await import(pathToFileURL(`${folder}/diagram.mjs`));
  return diagrams.map((diagram) => {
    const drawing = sketch({ origin: diagram.origin ?? [0, diagram.height], unit: diagram.unit ?? 1 });
    diagram.draw(drawing);
    return { path: `${folder}/${diagram.name}.svg`, svg: file(diagram, drawing.parts) };
  });
}

const words = process.argv.slice(2), check = words[0] === "--check";
if (check) words.shift();
const labs = readdirSync("solutions").filter((name) => /^\d\d-/.test(name) && name.startsWith(words[0] ?? "")).sort();
let wrong = 0;
for (const lab of labs) {
  const folder = `solutions/${lab}`;
  if (!existsSync(`${folder}/diagram.mjs`)) {
    console.log(`${folder}/diagram.mjs is missing: each handout has a diagram`);
    wrong++;
    continue;
  }
  for (const { path, svg } of await drawn(folder)) {
    const shown = readFileSync(`${folder}/README.md`, "utf8").includes(`](${path.slice(folder.length + 1)})`);
    if (!shown) console.log(`${folder}/README.md does not show ${path}`);
    const same = existsSync(path) && readFileSync(path, "utf8") === svg;
    if (check && !same) console.log(`${path} is not what ${folder}/diagram.mjs says: make diagrams skeletons`);
    if (!check && !same) console.log(path);
    if (!check && !same) writeFileSync(path, svg);
    wrong += !shown || (check && !same);
  }
}
process.exit(wrong ? 1 : 0);
