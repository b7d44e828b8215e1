// Points and directions in a plane, [x, y], for the diagrams and the figures.
export const add = ([a, b], [c, d]) => [a + c, b + d];
export const sub = ([a, b], [c, d]) => [a - c, b - d];
export const scale = ([a, b], k) => [a * k, b * k];
export const dot = ([a, b], [c, d]) => a * c + b * d;
export const cross = ([a, b], [c, d]) => a * d - b * c;
export const length = (a) => Math.hypot(...a);
export const unit = (a) => scale(a, 1 / length(a));
export const along = (a, b, t) => add(a, scale(sub(b, a), t));
export const clamp = (x, least, most) => Math.min(Math.max(x, least), most);
export const range = (n) => Array.from({ length: n }, (_, i) => i);
export const radians = (degrees) => (degrees * Math.PI) / 180;

// Where the line through a and b meets the line through c and d: t with along(a, b, t) on both; NaN for parallel lines.
export function meet(a, b, c, d) {
  const way = sub(d, c), across = cross(sub(b, a), way);
  return across === 0 ? NaN : cross(sub(c, a), way) / across;
}

// Where the ray from a through b comes to the height y.
export const fall = (a, b, y = 0) => along(a, b, (y - a[1]) / (b[1] - a[1]));

// Random numbers in [0, 1), the same for the same seed: splitmix32.
export function random(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x9e3779b9) >>> 0;
    let z = state;
    z = Math.imul(z ^ (z >>> 16), 0x21f0aaad);
    z = Math.imul(z ^ (z >>> 15), 0x735a2d97);
    return ((z ^ (z >>> 15)) >>> 0) / 2 ** 32;
  };
}
