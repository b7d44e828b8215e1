// frames.mjs [NN]: draws the labs that have a frames.json over a knob, with build/sweep, into build/frames/. Each entry of
// frames.json has title, about, label and unit for the page, and for sweep a scene, perhaps a view, the knob `over`, its values and other knobs.
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";

const labs = readdirSync("solutions").filter((name) => existsSync(`solutions/${name}/frames.json`) && name.startsWith(process.argv[2] ?? ""));
for (const lab of labs) {
  const entries = JSON.parse(readFileSync(`solutions/${lab}/frames.json`, "utf8"));
  const made = entries.map((entry, number) => {
    const knobs = Object.entries(entry.knobs).flatMap(([name, value]) => ["--knob", `${name}=${value}`]);
    const words = ["--lab", lab.slice(0, 2), "--scene", entry.scene, "--over", entry.over, "--view", entry.view ?? "picture", ...knobs, `build/frames/${lab}/${number}`, ...entry.values.map(String)];
    mkdirSync(`build/frames/${lab}`, { recursive: true });
    const lines = execFileSync("build/sweep", words, { encoding: "utf8" }).trim().split("\n");
    const frames = lines.map((line) => line.split(",").map(Number)).map(([value, shadow, light]) => ({ value, shadow, light }));
    return { ...entry, frames };
  });
  writeFileSync(`build/frames/${lab}/frames.json`, JSON.stringify(made));
  console.log(`build/frames/${lab}/frames.json`);
}
