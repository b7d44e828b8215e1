// How far a student is, from .progress.json (or where SHADOW_LAB_PROGRESS says), as it is when the site is made.
import { existsSync, readFileSync } from "node:fs";

const file = process.env.SHADOW_LAB_PROGRESS || ".progress.json";
const isNumber = (value) => typeof value === "number" && Number.isFinite(value);

// A lab's entry as grade/progress.c writes it, or undefined.
function entry(value) {
  if (!isNumber(value?.score) || !isNumber(value.max_score) || typeof value.done !== "boolean") return undefined;
  const day = /^\d{4}-\d\d-\d\d$/.test(value.done_on) ? value.done_on : "";
  return { score: Math.max(0, value.score), most: value.max_score, best: isNumber(value.best) ? value.best : value.score, done: value.done, day };
}

// From the lab's two digits to { score, most, best, done, day }; empty where nothing is noted. What is damaged is said, and left out.
export function progress() {
  const found = new Map();
  try {
    const text = existsSync(file) ? readFileSync(file, "utf8") : "";
    if (!text.trim()) return found;
    const labs = JSON.parse(text)?.labs;
    if (typeof labs !== "object" || labs === null) throw new Error("it has no labs");
    for (const [id, value] of Object.entries(labs)) if (/^\d\d$/.test(id) && entry(value)) found.set(id, entry(value));
  } catch (error) {
    console.error(`site: ${file} is damaged (${error.message}); the pages are made without it`);
    found.clear();
  }
  return found;
}

// What is said of one lab: "" for a lab that was not begun. Points are rounded down, so that what is nearly whole does not look whole.
export function told(those) {
  if (!those || (!those.done && !(those.best > 0))) return "";
  return those.done ? `✓ done${those.day ? ` on ${those.day}` : ""}` : `${Math.floor(those.score)} of ${Math.round(those.most)} points`;
}
