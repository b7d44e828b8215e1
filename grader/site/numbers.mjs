// Numbers as words, for the figures.
export const fixed = (x, digits = 2) => (Math.abs(x) < 0.5 * 10 ** -digits ? 0 : x).toFixed(digits).replace("-", "−");
export const percent = (x, digits = 0) => `${fixed(100 * x, digits)} %`;
export const signed = (n) => (n > 0 ? `+${n}` : String(n).replace("-", "−"));
