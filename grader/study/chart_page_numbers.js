// What a chart says in words and numbers: of the chosen setting, of all settings in a table, and of the methods' marks.
function numbers(scene, p) {
  const e = p.errors, rows = [
    ['time of a frame', `${digits(p.ms)} ± ${digits(p.mad)} ms, ${p.frames} frames`],
    ['before the picture (map, volumes, bake)', `${digits(p.prepare)} ± ${digits(p.prepareMad)} ms`],
    ['the picture', `${digits(p.shade)} ± ${digits(p.shadeMad)} ms`],
    ['error: mean, least and most of the views', `${percent(p.error)}, ${percent(p.low)}, ${percent(p.high)}`],
    ['root of the mean square', percent(p.rmse)], ['FLIP', percent(p.flip)],
    ['false shadow inside', percent(e.insideShadow)], ['false light inside', percent(e.insideLight)]
  ];
  if (scene.edges)
    rows.push(['false shadow at the edge', percent(e.edgeShadow)], ['false light at the edge', percent(e.edgeLight)],
              ['the edge is off by', `${digits(e.off)} pixels, at most ${digits(p.worstOff)}`]);
  rows.push(['enough in', `${p.enoughViews} of ${scene.views} views`]);
  if (scene.moves && !p.traced)
    rows.push(['changes beyond the truth\'s, a frame: the light turns', percent(p.turning)],
              ['the same: the camera moves', percent(p.moving)]);
  const costs =
      [['reads a pixel', p.taps], ['texels cleared or baked', p.texels], ['fragments', p.fragments], ['rays of the bake', p.rays],
       ['bytes of maps and textures', p.bytes], ['cost: reads, texels, fragments, rays x 100', p.counted]];
  rows.push(...costs.filter(([, cost]) => cost > 0).map(([name, cost]) => [name, digits(cost)]));
  return make(
      'table', {},
      make('tbody', {},
           ...rows.map(([name, value]) => make('tr', {}, make('th', {scope: 'row'}, name), make('td', {}, value)))));
}

function show(panel, scene, p) {
  const canvas = make('canvas', {
    width: scene.width,
    height: scene.height,
    role: 'img',
    'aria-label': `errors: false shadow ${percent(p.errors.insideShadow + p.errors.edgeShadow)}, false light ${
        percent(p.errors.insideLight + p.errors.edgeLight)}`
  });
  canvas.dataset.of = describe(p);
  const key = end => make('span', {class: 'key', style: `background: rgb(${errorColors[end]})`});
  panel.replaceChildren(
      make('h3', {}, `${p.submission ? 'Submission: ' : ''}${p.method}, ${p.setting} (${labOf(p)})`),
      make('div', {class: 'pictures'},
           make('figure', {}, make('img', {
                  src: p.frame,
                  alt: 'The frame: lit white, shadow black',
                  width: scene.width,
                  height: scene.height
                }),
                make('figcaption', {}, 'the frame: what light reaches each point')),
           make('figure', {}, canvas,
                make('figcaption', {}, key(0), ' false shadow, ', key(510), ' false light: the brighter, the more'))),
      numbers(scene, p));
  drawError(canvas, scene, p);
}

function tableOf(scene, points) {
  const heads = [
    'method and setting', 'lab', 'ms', 'MAD', 'picture, ms', 'error', 'RMSE', 'FLIP', 'edge off, px', 'reads', 'texels', 'fragments',
    'rays', 'bytes', 'cost', ...(scene.moves ? ['light turns', 'camera moves'] : []), 'front', 'enough'
  ];
  const row =
      p => [`${p.submission ? 'submission: ' : ''}${p.method}, ${p.setting}`, p.lab, digits(p.ms), digits(p.mad),
            digits(p.shade), percent(p.error), percent(p.rmse), percent(p.flip), scene.edges ? digits(p.errors.off) : '', digits(p.taps),
            digits(p.texels), digits(p.fragments), digits(p.rays), digits(p.bytes), digits(p.counted),
            ...(scene.moves ? [p.turning, p.moving].map(x => p.traced ? '' : percent(x)) : []), p.front ? 'yes' : '', p.enough ? 'yes' : `${p.enoughViews} of ${scene.views}`];
  return make(
      'details', {}, make('summary', {}, `All ${points.length} settings as a table`),
      make('div', {class: 'wide', tabindex: 0, role: 'region', 'aria-label': `Settings of ${scene.title}`},
           make('table', {}, make('thead', {}, make('tr', {}, ...heads.map(h => make('th', {scope: 'col'}, h)))),
                make('tbody', {}, ...points.map(p => make('tr', {}, ...row(p).map(cell => make('td', {}, cell))))))));
}

function legend(points) {
  const seen = new Map(points.map(p => [p.family, p])); // one of each
  return make(
      'ul', {class: 'legend', 'aria-label': 'Methods'},
      ...[...seen.values()]
          .sort((a, b) => a.family - b.family)
          .map(p => make('li', {}, make('svg', {viewBox: '-8 -8 16 16', 'aria-hidden': 'true'}, shape(p, 0, 0, 6)),
                         (p.submission ? 'submission: ' : '') + p.method)));
}
