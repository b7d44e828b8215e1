// sRGB, its linear light and OKLab (Ottosson 2020), in which the colours of errors are mixed.
const linear = c => c <= .04045 ? c / 12.92 : ((c + .055) / 1.055) ** 2.4;
const gamma = c =>
    Math.round(255 * (c <= .0031308 ? 12.92 * Math.max(c, 0) : Math.min(1.055 * c ** (1 / 2.4) - .055, 1)));
function lab([r, g, b]) {
  [r, g, b] = [r, g, b].map(c => linear(c / 255));
  const [l, m, s] = [
    .4122214708 * r + .5363325363 * g + .0514459929 * b, .2119034982 * r + .6806995451 * g + .1073969566 * b,
    .0883024619 * r + .2817188376 * g + .6299787005 * b
  ].map(Math.cbrt);
  return [
    .2104542553 * l + .793617785 * m - .0040720468 * s, 1.9779984951 * l - 2.428592205 * m + .4505937099 * s,
    .0259040371 * l + .7827717662 * m - .808675766 * s
  ];
}
function rgb([L, a, b]) {
  const [l, m, s] = [
    L + .3963377774 * a + .2158037573 * b, L - .1055613458 * a - .0638541728 * b,
    L - .0894841775 * a - 1.291485548 * b
  ].map(c => c ** 3);
  return [
    4.0767416621 * l - 3.3077115913 * m + .2309699292 * s, -1.2684380046 * l + 2.6097574011 * m - .3413193965 * s,
    -.0041960863 * l - .7034186147 * m + 1.707614701 * s
  ].map(gamma);
}
const none = lab([46, 46, 46]), bright = lab([255, 208, 32]), dark = lab([64, 128, 255]);
const errorColors = Array.from({length: 511}, (_, i) => {
  const error = (i - 255) / 255, end = error > 0 ? bright : dark, share = Math.sqrt(Math.abs(error));
  return rgb(none.map((c, k) => c + share * (end[k] - c)));
});

async function pixels(url) {
  const image = new Image();
  image.src = url;
  await image.decode();
  const canvas = make('canvas', {width: image.width, height: image.height}), context = canvas.getContext('2d');
  context.drawImage(image, 0, 0);
  return context.getImageData(0, 0, image.width, image.height);
}

async function drawError(canvas, scene, p) {
  const [frame, truth] = await Promise.all([pixels(p.frame), pixels(scene.truth)]);
  for (let i = 0; i < frame.data.length; i += 4) {
    const counts = truth.data[i + 1] > 0, error = frame.data[i] - truth.data[i];
    const shown = counts ? errorColors[255 + error] : [18, 18, 18];
    for (let k = 0; k < 3; k++)
      frame.data[i + k] = shown[k];
  }
  if (canvas.dataset.of === describe(p))
    canvas.getContext('2d').putImageData(frame, 0, 0);
}
