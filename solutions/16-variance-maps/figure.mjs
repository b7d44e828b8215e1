// The figure of lab 16: a filter that sees an upper plate, a lower one or the receiver; what two moments make of it.
import { clamp } from "../../grader/site/geometry.mjs";
import { fixed, percent } from "../../grader/site/numbers.mjs";

const HIGH = 4; // of the light above the receiver

// The depths that the filter sees, nearest first, with their shares.
export function seen({ upper, lower, two, width, at }) {
  const share = (end) => clamp((end - at[0]) / width + 0.5, 0, 1), q = share(upper[0]), r = two ? Math.max(share(lower[0]), q) : q;
  return [[HIGH - upper[1], q], [HIGH - lower[1], r - q], [HIGH, 1 - r]];
}

// The mean of the depths, their variance, and the bound on what is as far as the receiver; with a cut.
export function bound(state) {
  const depths = seen(state), mean = depths.reduce((sum, [t, share]) => sum + t * share, 0);
  const variance = depths.reduce((sum, [t, share]) => sum + (t - mean) ** 2 * share, 0), beyond = HIGH - mean;
  const light = beyond < 1e-9 ? 1 : variance / (variance + beyond * beyond);
  return { mean, variance, light, left: clamp((light - state.cut) / (1 - state.cut), 0, 1) };
}

// The share of the filter that is lit: what it would be by taps.
export const truth = (state) => seen(state)[2][1];

// The most light that two plates let through, whatever the share.
export const most = ({ upper, lower }) => {
  const a = upper[1] - lower[1], b = lower[1];
  return a > 0 ? (a / (a + 2 * b)) ** 2 : 0;
};

function draw(s, state) {
  const { upper, lower, two, width, at } = state, [from, to] = [at[0] - width / 2, at[0] + width / 2];
  s.area([[from, HIGH], [to, HIGH], [to, 0], [from, 0]], "half");
  s.line([-3, 0], [3, 0], "surface");
  s.line([-3, upper[1]], [upper[0], upper[1]], "surface");
  if (two) s.line([-3, lower[1]], [lower[0], lower[1]], "surface");
  const mean = HIGH - bound(state).mean;
  s.line([from, mean], [to, mean], "mark");
  s.text([to, mean], "mean", "e", "mark");
  s.text([at[0], HIGH], "filter", "n", "quiet");
}

function numbers(state) {
  const { mean, variance, light, left } = bound(state), lit = truth(state), error = left - lit;
  return [
    ["mean depth", fixed(mean, 3)],
    ["variance", fixed(variance, 3)],
    ["the bound", percent(light, 1)],
    ["after the cut", percent(left, 1)],
    ["in truth", percent(lit, 1)],
    ["error", fixed(error, 3), Math.abs(error) > 0.05 ? "bad" : ""],
    ["most that can bleed", state.two ? percent(most(state), 1) : "nothing"],
  ];
}

export const figure = {
  title: "Play: what two moments can tell.",
  about: "Drag the plates' ends and the filter. With one plate the bound is the truth; under two there is light that nobody sent.",
  view: { width: 640, height: 360, unit: 70, origin: [310, 320], text: "A filter over plates and a receiver" },
  knobs: {
    width: { label: "width of the filter", least: 0.1, most: 3, step: 0.05, value: 1.4 },
    cut: { label: "cut", least: 0, most: 0.9, step: 0.01, value: 0 },
    two: { label: "plates", choices: ["one", "two"], value: 1 },
  },
  points: {
    upper: { label: "upper plate", at: [0, 2.8], box: [[-2.5, 1.6], [2.5, 3.6]], step: 0.05 },
    lower: { label: "lower plate", at: [1.6, 0.8], box: [[-2.5, 0.2], [2.5, 1.5]], step: 0.05, when: ({ two }) => two > 0 },
    at: { label: "filter", at: [0.2, 0], box: [[-2.4, 0], [2.4, 0]], step: 0.05 },
  },
  draw, numbers,
};
