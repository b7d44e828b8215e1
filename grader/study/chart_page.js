// The charts: points that show their setting. `scenes` stands before this file.
const narrow = matchMedia('(max-width: 40rem)'), leastError = 1e-6, beyond = 3;
let size;
function setSize() {
  size = {width: narrow.matches ? 400 : 760, height: 500, left: 64, right: 14, top: 14, bottom: 46};
}
setSize();
const across = document.getElementById('across'), figure = document.getElementById('figure');
const time = p => p[across.value], mad = p => ({ms: p.mad, shade: p.shadeMad, cost: 0})[across.value];
const isCost = () => across.value === 'cost';
const digits = x => x === 0     ? '0'
                    : x >= 1000 ? Math.round(x).toLocaleString('en')
                                : Number(x.toPrecision(3)).toString();
const percent = x => digits(100 * x) + ' %';

function make(name, attributes = {}, ...children) {
  const isDrawing = ['svg', 'g', 'path', 'line', 'circle', 'text', 'rect', 'title'].includes(name);
  const element =
      isDrawing ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes))
    element.setAttribute(key, value);
  element.append(...children);
  return element;
}

// Shapes of area about r squared times three, one for each family in turn.
function shape(p, x, y, r) {
  const polygon = points => 'M' + points.map(([u, v]) => `${x + u * r},${y + v * r}`).join('L') + 'Z';
  const cross = `M${x - r},${y - r}L${x + r},${y + r}M${x - r},${y + r}L${x + r},${y - r}`;
  if (p.submission)
    return make('path', {d: cross, stroke: p.color, 'stroke-width': 3});
  const paths = [
    null, polygon([[-.9, -.9], [.9, -.9], [.9, .9], [-.9, .9]]), polygon([[0, -1.2], [1.1, .8], [-1.1, .8]]),
    polygon([[0, 1.2], [1.1, -.8], [-1.1, -.8]]), polygon([[0, -1.3], [1.1, 0], [0, 1.3], [-1.1, 0]])
  ];
  const open = p.family >= paths.length,
        style = open ? {fill: '#fff', stroke: p.color, 'stroke-width': 2} : {fill: p.color};
  const path = paths[p.family % paths.length];
  return path ? make('path', {d: path, ...style}) : make('circle', {cx: x, cy: y, r, ...style});
}

// A logarithmic axis over these values: from a value to pixels, and its ticks.
function axis(values, from, to, steps) {
  const low = Math.min(...values) / 1.25, high = Math.max(...values) * 1.25, span = Math.log(high / low), ticks = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); power++)
    for (const step of steps) {
      const tick = step * 10 ** power;
      if (tick >= low && tick <= high)
        ticks.push(tick);
    }
  return {place: value => from + Math.log(value / low) / span * (to - from), ticks};
}

function drawAxes(svg, scene, x, y) {
  const right = size.width - size.right, bottom = size.height - size.bottom,
        back = make('g', {'aria-hidden': 'true'});
  for (const tick of x.ticks)
    back.append(make('line', {class: 'grid', x1: x.place(tick), x2: x.place(tick), y1: size.top, y2: bottom}),
                make('text', {x: x.place(tick), y: bottom + 18, 'text-anchor': 'middle'}, digits(tick)));
  for (const tick of y.ticks)
    back.append(make('line', {class: 'grid', x1: size.left, x2: right, y1: y.place(tick), y2: y.place(tick)}),
                make('text', {x: size.left - 6, y: y.place(tick) + 4, 'text-anchor': 'end'},
                     tick <= leastError * 1.01 ? 'none' : percent(tick)));
  back.append(
      make('rect', {class: 'axis', x: size.left, y: size.top, width: right - size.left, height: bottom - size.top}),
      make('text', {x: (size.left + right) / 2, y: size.height - 8, 'text-anchor': 'middle'},
           isCost() ? 'counted cost a pixel' : `${scene.clock} time of a frame, ms`),
      make('text',
           {x: 14, y: size.height / 2, transform: `rotate(-90 14 ${size.height / 2})`, 'text-anchor': 'middle'},
           figure.selectedOptions[0].textContent));
  svg.append(back);
}

const errorOf = p => Math.max(p[figure.value], leastError);
const labOf = p => p.traced ? 'no lab' : `lab ${p.lab}`;

function drawFront(svg, points, x, y) {
  const front = points.filter(p => p.front && !p.submission);
  if (across.value !== 'ms' || front.length === 0)
    return; // the front is that of whole frames' times
  let path = `M${x.place(time(front[0]))},${y.place(errorOf(front[0]))}`;
  for (const p of front.slice(1))
    path += `H${x.place(time(p))}V${y.place(errorOf(p))}`;
  svg.append(make('path', {class: 'front', d: path, 'aria-hidden': 'true'}));
}

function describe(p) {
  return `${p.submission ? 'submission, ' : ''}${p.method}, ${p.setting}, ${labOf(p)}: ${
             digits(time(p))} ${isCost() ? 'a pixel' : 'ms'}, error ${percent(p[figure.value])}` +
         (p.front ? ', on the front' : '') + (p.chosen ? ', what this scene needs' : '');
}

// Boxes [left, top, right, bottom] that no name or label may cover.
const letters = {wide: 7, high: 12};
const boxAt = (x, y, text) => [x - text.length * letters.wide / 2, y - letters.high / 2, x + text.length * letters.wide / 2, y + letters.high / 2];
const isFree = (box, taken) => taken.every(([l, t, r, b]) => box[0] >= r || l >= box[2] || box[1] >= b || t >= box[3]);
const markBox = ([u, v]) => [u - 6, v - 6, u + 6, v + 6];
const isWithin = box => box[0] >= size.left && box[2] <= size.width - size.right && box[1] >= size.top && box[3] <= size.height - size.bottom;
const small = (box, text) => make('text', {class: 'small', x: (box[0] + box[2]) / 2, y: box[3] - 2, 'text-anchor': 'middle'}, text);

// Lines that every method is held against, as far as they lie within the chart. Each name stands as far to the right
// as nothing is in its way.
function drawLines(svg, scene, y, taken) {
  const right = size.width - size.right;
  for (const line of scene.lines) {
    const down = y.place(errorOf(line)), half = line.name.length * letters.wide / 2, boxes = [];
    if (down < size.top || down > size.height - size.bottom)
      continue;
    for (let x = right - 4 - half; x > size.left + half; x -= 20)
      boxes.push(boxAt(x, down - 9, line.name), boxAt(x, down + 9, line.name));
    const box = boxes.find(b => isWithin(b) && isFree(b, taken)) || boxes[0];
    taken.push(box);
    svg.append(make('line', {class: line.floor ? 'line floor' : 'line', x1: size.left, x2: right, y1: down, y2: down}),
               small(box, line.name));
  }
}

// What is chosen and the front have their settings beside their marks, as far as there is room.
function drawLabels(svg, points, places, taken) {
  const wanted = points.map((p, i) => ({p, at: places[i]})).filter(({p}) => p.front || p.chosen);
  for (const {p, at: [u, v]} of wanted.sort((a, b) => b.p.chosen - a.p.chosen)) {
    const aside = p.label.length * letters.wide / 2 + 7;
    const box = [[aside, 0], [-aside, 0], [0, -13], [0, 13], [aside, -11], [-aside, -11], [aside, 11], [-aside, 11]]
                    .map(([x, y]) => boxAt(u + x, v + y, p.label))
                    .find(b => isWithin(b) && isFree(b, taken));
    if (!box)
      continue;
    taken.push(box);
    const label = small(box, p.label);
    label.setAttribute('aria-hidden', 'true');
    svg.append(label);
  }
}

// Places of marks, none on another one and none outside: ring by ring around where the numbers say.
function placeMarks(points, x, y) {
  const radius = 5, placed = [];
  const hasRoom = ([u, v]) => placed.every(([a, b]) => Math.abs(a - u) >= 2 * radius || Math.abs(b - v) >= 2 * radius);
  for (const p of points) {
    const at = [x.place(Math.max(time(p), 1e-3)), y.place(errorOf(p))], places = [at];
    for (let ring = 1; ring < 24; ring++)
      for (let d = 0; d < 12; d++)
        places.push([at[0] + ring * radius * Math.cos(d * Math.PI / 6), at[1] + ring * radius * Math.sin(d * Math.PI / 6)]);
    placed.push(places.find((place, i) => hasRoom(place) && (i === 0 || isWithin(markBox(place)))) || at);
  }
  return placed;
}

function drawCurves(svg, points, x, y) {
  for (const p of points) {
    const from = points.find(q => q.method === p.method && q.submission === p.submission && q.setting === p.from);
    if (from)
      svg.append(make('line', {
        class: 'curve',
        stroke: p.color,
        x1: x.place(time(from)),
        y1: y.place(errorOf(from)),
        x2: x.place(time(p)),
        y2: y.place(errorOf(p))
      }));
  }
}

// The mark stands at [u, v], what it says at its bars' crossing.
function drawPoint(p, x, y, [u, v]) {
  const at = x.place(Math.max(time(p), 1e-3)), down = y.place(errorOf(p));
  const ends = [Math.max(time(p) - mad(p), time(p) / 2), time(p) + mad(p)].map(x.place);
  const point =
      make('g', {class: 'point', role: 'option', tabindex: -1, 'aria-selected': 'false', 'aria-label': describe(p)},
           make('title', {}, describe(p)), make('circle', {class: 'halo', cx: u, cy: v, r: 9}),
           make('line', {class: 'bar', x1: ends[0], x2: ends[1], y1: down, y2: down, stroke: p.color}));
  if (figure.value === 'error')
    point.append(make('line', {
      class: 'bar',
      x1: at,
      x2: at,
      y1: y.place(Math.max(p.low, leastError)),
      y2: y.place(Math.max(p.high, leastError)),
      stroke: p.color
    }));
  if (u !== at || v !== down)
    point.append(make('line', {class: 'away', x1: at, y1: down, x2: u, y2: v}));
  point.append(shape(p, u, v, 4.5), make('circle', {cx: u, cy: v, r: 8, fill: 'transparent'}));
  if (p.chosen)
    point.prepend(make('circle', {class: 'need', cx: u, cy: v, r: 13}));
  return point;
}

// The chart of a scene. `chosen` is the point that is shown at first; `choose` is told of another.
function drawChart(scene, points, chosen, choose) {
  const svg = make(
      'svg', {viewBox: `0 0 ${size.width} ${size.height}`, role: 'group', 'aria-label': `Chart: ${scene.title}`});
  const times = points.flatMap(p => [time(p), time(p) + mad(p)]).map(t => Math.max(t, 1e-3));
  const wide = Math.max(...times) > 300 * Math.min(...times); // numbers of all steps would run into each other
  const x = axis(times, size.left, size.width - size.right,
                 narrow.matches ? (wide ? [1] : [1, 3]) : wide ? [1, 3] : [1, 1.5, 2, 3, 5, 7]);
  const errors = [...points, ...scene.lines.filter(line => line.floor)].map(errorOf),
        few = Math.max(...errors) < 100 * Math.min(...errors);
  const y = axis(errors, size.height - size.bottom, size.top, few ? [1, 2, 5] : [1]), places = placeMarks(points, x, y);
  drawAxes(svg, scene, x, y);
  const taken = places.map(markBox);
  drawFront(svg, points, x, y);
  drawCurves(svg, points, x, y);
  drawLines(svg, scene, y, taken);
  const list = make('g', {role: 'listbox', 'aria-label': `Settings of ${scene.title}, by time or cost`}),
        marks = points.map((p, i) => drawPoint(p, x, y, places[i]));
  const select = (i, focus) => {
    marks.forEach((mark, j) => {
      mark.setAttribute('aria-selected', i === j);
      mark.setAttribute('tabindex', i === j ? 0 : -1);
    });
    if (focus)
      marks[i].focus();
    choose(points[i]);
  };
  marks.forEach((mark, i) => {
    mark.addEventListener('click', () => select(i, true));
    mark.addEventListener('keydown', event => {
      const next = {
        ArrowRight: i + 1,
        ArrowDown: i + 1,
        ArrowLeft: i - 1,
        ArrowUp: i - 1,
        Home: 0,
        End: marks.length - 1,
        Enter: i,
        ' ': i
      }[event.key];
      if (next === undefined)
        return;
      event.preventDefault();
      if (marks[next])
        select(next, true);
    });
  });
  list.append(...marks);
  svg.append(list);
  drawLabels(svg, points, places, taken);
  select(Math.max(points.indexOf(chosen), 0), false);
  return svg;
}

function drawScene(scene) {
  scene.points.forEach(p => p.cost = p.counted / (scene.width * scene.height));
  const chart = make('div'),
        panel = make('section', {'aria-live': 'polite', 'aria-label': `The setting, ${scene.title}`});
  let current = scene.points.find(p => p.chosen) || scene.points[0];
  const draw = () => {
    const all = [...scene.points].sort((a, b) => time(a) - time(b));
    const most = beyond * Math.max(...all.filter(p => !p.traced).map(p => p.ms));
    const points = all.filter(p => isCost() ? p.cost > 0 : !p.traced || p.ms <= most); // rays of the truth are not counted
    chart.replaceChildren(drawChart(scene, points, current, p => {
                            current = p;
                            show(panel, scene, p);
                          }), legend(points), tableOf(scene, all));
  };
  across.addEventListener('change', draw);
  figure.addEventListener('change', draw);
  narrow.addEventListener('change', () => {
    setSize();
    draw();
  });
  draw();
  return make('section', {id: scene.name, 'aria-label': scene.title}, make('h2', {}, scene.title),
              make('p', {}, `Shows: ${scene.shows}. Drawn by ${scene.renderer}.`),
              make('p', {}, make('strong', {}, 'What it needs: '), scene.need + '.'),
              make('div', {class: 'scene'}, chart, panel));
}

document.getElementById('scenes').append(...scenes.map(drawScene));
