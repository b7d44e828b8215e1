// A figure to play with, in a browser: points are dragged by mouse, finger or arrow keys, knobs are the browser's own
// controls, numbers stand below. README.md says what a figure is.
import { sketch } from "./sketch.mjs";
import { fixed } from "./numbers.mjs";

// The state that a figure begins with: a number for each knob, [x, y] for each point.
export function start(figure) {
  const state = {};
  for (const [name, knob] of Object.entries(figure.knobs ?? {})) state[name] = knob.value;
  for (const [name, point] of Object.entries(figure.points ?? {})) state[name] = [...point.at];
  return state;
}

// Each point is in its box, and where the figure wants it, whichever of them was moved. Changes `state`.
export function settle(figure, state) {
  for (const [name, { box: [[left, bottom], [right, top]], keep = (point) => point }] of Object.entries(figure.points ?? {})) {
    const [x, y] = state[name];
    state[name] = keep([Math.min(Math.max(x, left), right), Math.min(Math.max(y, bottom), top)], state);
  }
}

const shown = (knob, value) => knob.choices?.[value] ?? `${fixed(value, knob.digits ?? 2)}${knob.unit ?? ""}`;
const said = ([x, y]) => `x ${fixed(x)}, y ${fixed(y)}`;

function knobs(figure) {
  return Object.entries(figure.knobs ?? {}).map(([name, { label, choices, least, most, step, value }]) => {
    const options = choices?.map((words, i) => `<option value="${i}"${i === value ? " selected" : ""}>${words}</option>`).join("");
    const control = choices ? `<select data-knob="${name}">${options}</select>` :
      `<input type="range" data-knob="${name}" min="${least}" max="${most}" step="${step}" value="${value}"><output></output>`;
    return `<label><span>${label}</span>${control}</label>`;
  }).join("");
}

// One stop of Tab for each point: it is a slider with two dimensions. The words say where it is.
function grips(figure) {
  return Object.entries(figure.points ?? {}).map(([name, { label, box: [[x], [u]] }]) =>
    `<g class="grip" role="slider" tabindex="0" data-point="${name}" aria-label="${label}: arrow keys move it" aria-valuemin="${x}" aria-valuemax="${u}">` +
    `<circle class="reach" r="24"/><circle class="ring" r="12"/></g>`).join("");
}

// Real frames on a slider: `host` holds them all in order, and the numbers below.
export function frames(host) {
  const all = [...host.querySelectorAll("[data-frame]")], control = host.querySelector("input");
  const show = () => {
    all.forEach((frame) => (frame.hidden = Number(frame.dataset.frame) !== Number(control.value)));
    const words = host.querySelector("div[data-frame]:not([hidden])").dataset.words;
    control.setAttribute("aria-valuetext", words);
    host.querySelector("output").textContent = words;
  };
  control.addEventListener("input", show);
  host.hidden = false;
  show();
}

// Makes the figure in `host`, whose `hidden` goes.
export function play(figure, host) {
  const { width, height, text } = figure.view;
  let state = start(figure);
  host.innerHTML = `<figcaption><strong>${figure.title}</strong> ${figure.about}</figcaption>
<svg viewBox="0 0 ${width} ${height}" role="group" aria-label="${text}"><rect class="card" width="${width}" height="${height}" rx="8"/><g class="drawing" aria-hidden="true"></g>${grips(figure)}</svg>
<div class="knobs">${knobs(figure)}<button type="button">Back to the start</button></div><dl aria-live="polite"></dl>`;
  host.hidden = false;
  const svg = host.querySelector("svg"), { place } = sketch(figure.view);
  const all = (selector) => [...host.querySelectorAll(selector)];

  function draw() {
    const drawing = sketch(figure.view);
    figure.draw(drawing, state);
    host.querySelector(".drawing").innerHTML = drawing.parts.join("");
    const rows = figure.numbers(state).map(([label, value, kind]) => `<div${kind ? ` class="${kind}"` : ""}><dt>${label}</dt><dd>${value}</dd></div>`);
    host.querySelector("dl").innerHTML = rows.join("");
    for (const grip of all(".grip")) {
      const point = state[grip.dataset.point], [x, y] = place(point), { when = () => true } = figure.points[grip.dataset.point];
      grip.style.display = when(state) ? "" : "none"; // what is not drawn cannot be dragged
      grip.setAttribute("transform", `translate(${x} ${y})`);
      grip.setAttribute("aria-valuenow", fixed(point[0]).replace("−", "-"));
      grip.setAttribute("aria-valuetext", said(point));
    }
    for (const control of all("[data-knob]")) {
      const knob = figure.knobs[control.dataset.knob], value = state[control.dataset.knob];
      control.value = value;
      control.closest("label").hidden = knob.when !== undefined && !knob.when(state);
      if (knob.choices) continue;
      control.setAttribute("aria-valuetext", shown(knob, value));
      control.nextElementSibling.textContent = shown(knob, value);
    }
  }

  function move(name, point) {
    state[name] = point;
    settle(figure, state);
    draw();
  }

  function pointed(event) {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    const { origin, unit } = figure.view;
    return [(at.x - origin[0]) / unit, (origin[1] - at.y) / unit];
  }

  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  for (const grip of all(".grip")) {
    const name = grip.dataset.point, step = figure.points[name].step ?? 0.1;
    grip.addEventListener("pointerdown", (event) => {
      grip.setPointerCapture(event.pointerId);
      grip.focus();
      event.preventDefault();
    });
    grip.addEventListener("pointermove", (event) => grip.hasPointerCapture(event.pointerId) && move(name, pointed(event)));
    grip.addEventListener("keydown", (event) => {
      const way = steps[event.key];
      if (!way) return;
      event.preventDefault();
      move(name, state[name].map((x, i) => x + way[i] * step * (event.shiftKey ? 5 : 1)));
    });
  }
  for (const control of all("[data-knob]"))
    control.addEventListener("input", () => {
      state[control.dataset.knob] = Number(control.value);
      draw();
    });
  host.querySelector("button").addEventListener("click", () => {
    state = start(figure);
    draw();
  });
  draw();
}
