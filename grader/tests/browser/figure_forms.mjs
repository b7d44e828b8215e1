// The closed forms of each lab's figure, worked out by hand or independent of the figure's own way. Each is told of the functions
// of solutions/NN-name/figure.mjs.
import { all, between, equal, near, next, times } from './figure_checks.mjs';

export const models = {
    async '01'(m) {
        const state = { lamp: [3, 4], eye: [-3, 4], model: 2, shininess: 10 }; // the eye stands where the ray is reflected to
        near('01: n.l of a 3-4-5 triangle', m.vectors(state).facing, 0.8);
        near('01: r.v on the way of the ray', m.vectors(state).mirrored, 1);
        near('01: Phong, 0.14 + 0.56 * 0.8 + 0.32', m.shade(state), 0.908);
        near('01: the eye by the lamp: r.v = 2 * 0.64 - 1', m.vectors({ ...state, eye: [3, 4] }).mirrored, 0.28);
        near('01: no light from below', m.shade({ ...state, lamp: [3, -4], eye: [3, 4] }), 0.14);
        near('01: posterised', m.finish(0.908, { finish: 1 }), 1);
        near('01: posterised, 0.6', m.finish(0.6, { finish: 1 }), 0.5);
    },
    async '02'(m) {
        const planes = { near: 1, far: 3, bits: 10 };
        near('02: the near plane', m.depth(1, planes), 0);
        near('02: the far plane', m.depth(3, planes), 1);
        near('02: half at 2nf/(n + f)', m.depth(1.5, planes), 0.5);
        near('02: at distance 2: z = 2 - 1.5', m.depth(2, planes), 0.75);
        all('02: back to the distance', 100, () => { const d = between(1, 3); return m.distance(m.depth(d, planes), planes) - d; });
        near('02: the quantum, d^2 (f - n) / (f n) / 2^10', m.step(3, planes), 6 / 1024);
    },
    async '03'(m) {
        const state = { lamp: [0, 4], board: [0, 2], texels: 18 }; // a texel is 0.4 wide on the floor; the board is 1.3 wide
        const both = m.shadows(state);
        near('03: a H / (H - h)', both.truth[1] - both.truth[0], 2.6);
        near('03: texels with their middle in it: 0, 0.4, 0.8 and 1.2 are not ..., 0.2 to 1.0 are', both.map[1], 1.2);
        near('03: wrong on both sides', m.wrong(both), 0.2);
        near('03: nothing of the map in shadow: all is wrong', m.wrong({ truth: [1, 2], map: undefined }), 1);
        near('03: depth at the near plane', m.depth(0.5), 0);
        near('03: depth at the far plane', m.depth(7), 1);
        near('03: half at 2nf/(n + f)', m.depth(7 / 7.5), 0.5);
        equal('03: no texel outside of the map', m.texel(3.7, state), undefined);
        equal('03: the first texel', m.texel(-3.59, state), 0);
        equal('03: the last texel', m.texel(3.59, state), 17);
        // The mean over many places: a quarter of a texel at each of the two edges.
        const mean = times(4000, () => m.wrong(m.shadows({ ...state, texels: 64, board: [between(-1, 1), between(1, 2)] }))).reduce((a, b) => a + b) / 4000;
        near('03: a quarter of a texel an edge', mean / 2 / (7.2 / 64), 0.25, 0.01);
    },
    async '04'(m) {
        const scene = (more) => m.setup({ sun: [-1, 1], top: [0, 1.4], texels: 20, method: 0, bias: 0, factor: 0, normal: 0, ...more }); // theta = 45 degrees, s = 0.4
        near('04: b0 = s/2 tan theta', m.formulas(scene()).least, 0.2);
        for (const [bias, share] of [[0, 0.5], [0.1, 0.25], [0.15, 0.125], [0.2, 0], [0.3, 0]])
            near(`04: acne with the bias ${bias}`, m.measured(scene({ bias })).acne, share, 0.002);
        for (const texels of [8, 21, 80]) near(`04: half at every resolution: ${texels}`, m.measured(scene({ texels })).acne, 0.5, 0.002);
        near('04: a normal offset of half a texel is enough', m.measured(scene({ method: 3, normal: 0.5 })).acne, 0, 0.002);
        near('04: half of it leaves a quarter', m.measured(scene({ method: 3, normal: 0.25 })).acne, 0.25, 0.002);
        near('04: a factor of one half is enough', m.measured(scene({ method: 2, factor: 0.5 })).acne, 0, 0.002);
        near('04: slope bias, b (1 - cos 45)', m.bias(scene({ method: 1, bias: 1 })), 1 - Math.SQRT1_2);
        for (const bias of [0.3, 0.6, 0.9])
            near(`04: gap b sin theta, ${bias}`, m.measured(scene({ bias, texels: 800 })).gap, bias * Math.SQRT1_2, 0.02);
        near('04: no gap with a normal offset', m.measured(scene({ method: 3, normal: 0.6, texels: 800 })).gap, 0, 0.02);
        all('04: acne follows (1 - r)/2 at any angle', 40, () => {
            const theta = between(0.2, 1.3), any = scene({ sun: [-Math.sin(theta), Math.cos(theta)] }), r = between(0, 1.2);
            return m.measured({ ...any, bias: r * m.formulas(any).least }).acne - Math.max(0, (1 - r) / 2);
        }, 0.002);
        // The tip of a fine map's shadow with a normal offset: delta tan theta nearer.
        const tip = scene({ method: 3, normal: 4, texels: 800 }), places = times(4000, (i) => 1.4 * (i + 0.5) / 4000);
        near('04: the tip moves by delta tan theta', 1.4 - Math.max(...places.filter((x) => m.dark(x, tip))), m.formulas(tip).tip, 0.02);
    },
    async '05'(m) {
        const state = { point: [5, 3.4], edge: [6, 1], angle: 0, radius: 0, filter: 0 };
        near('05: an edge at the texels\' border, nearest: nothing wrong', m.row(3.4, state).error, 0);
        for (const radius of [0, 1, 2, 3]) {
            const { error, ramp } = m.row(3.4, { ...state, radius, filter: 1 });
            near(`05: w/4 with radius ${radius}`, error, (2 * radius + 1) / 4, 1e-3);
            near(`05: a ramp of 2k + 1 texels, radius ${radius}`, ramp, 2 * radius + 1, 1 / 12);
        }
        const mean = (angle) => times(200, (i) => m.row(3.4, { ...state, angle, edge: [6 + (i + 0.5) / 200, 3.4] }).error).reduce((a, b) => a + b) / 200;
        near('05: a hard map, the mean over places: a quarter texel', mean(0), 0.25, 0.005);
        near('05: at 45 degrees 0.2357', mean(45), 0.2357, 0.005);
        near('05: a tap between four texels, two lit', m.visibility([6, 3], { ...state, filter: 1 }), 0.5);
        near('05: 3 x 3 with one column lit', m.visibility([5.5, 3.5], { ...state, radius: 1 }), 1 / 3);
        near('05: one linear tap a quarter into the light', m.visibility([6.25, 3.5], { ...state, filter: 1 }), 0.75);
        near('05: the bias reaches k + 1', m.reach({ radius: 2, filter: 1 }), 3);
    },
    async '06'(m) {
        const edge = (x) => m.truth({ caster: [x, 0], kind: 0 });
        near('06: an edge through the middle', edge(0), 0.5);
        near('06: all lit', edge(-1), 1);
        near('06: V(1/2) = 1/2 + (sqrt(3)/4 + pi/6)/pi', edge(-0.5), 0.5 + Math.sqrt(3) / 4 / Math.PI + 1 / 6);
        near('06: a small caster in the middle, 1 - b^2', m.truth({ caster: [0, 0], kind: 1, size: 0.5 }), 0.75);
        near('06: two equal circles, 1 apart: 2 pi/3 - sqrt(3)/2', m.lens(1, 1), 2 * Math.PI / 3 - Math.sqrt(3) / 2);
        near('06: circles that do not meet', m.lens(0.5, 1.6), 0);
        const state = { columns: 4, rows: 8, jitter: 1, pattern: 3, caster: [0, 0], kind: 1, size: 0.86, early: 1 }, radii = m.samples(state).map((at) => Math.hypot(...at));
        near('06: the first eight lie beyond 0.866', Number(Math.min(...radii.slice(0, 8)) >= Math.sqrt(0.75)), 1);
        near('06: a ring of equal area each', radii.slice(8, 12).filter((r) => r * r >= 5 / 8 && r * r < 6 / 8).length, 4);
        near('06: early-out misses a caster of 0.86', m.visibility(state).value, 1);
        equal('06: with eight samples', m.visibility(state).used, 8);
        near('06: without it the error is small', m.visibility({ ...state, early: 0 }).value, 1 - 0.86 ** 2, 0.05);
        all('06: the lens against many random points', 5, () => {
            const b = between(0.2, 1.4), d = between(0.1, 1.5), n = 40000;
            const inside = times(n, () => m.inDisc([next(), next()])).filter(([x, y]) => Math.hypot(x - d, y) < b).length / n;
            return m.lens(b, d) / Math.PI - inside;
        }, 0.01);
    },
    async '07'(m) {
        // A box of 1.1 x 0.8 around (5, 3), the lamp straight above at (5, 6): its upper corners (4.45, 3.4) and (5.55, 3.4).
        const boxes = [[5, 3]], lamp = [5, 6], eye = [0, 1];
        const under = m.counts({ eye, lamp, boxes }, [5, 0]), beside = m.counts({ eye, lamp, boxes }, [9, 0]), before = m.counts({ eye, lamp, boxes }, [1, 0]);
        equal('07: into the volume', under.pass, 1);
        equal('07: through the volume', beside.pass, 0);
        equal('07: before the volume', before.pass, 0);
        equal('07: z-fail under the box', under.fail, 1);
        equal('07: an eye in it: z-pass is one too small', m.counts({ eye: [5, 1], lamp, boxes }, [9, 0]).pass, -1);
        equal('07: an eye in it: z-fail is right', m.counts({ eye: [5, 1], lamp, boxes }, [9, 0]).fail, 0);
        equal('07: that eye is in one volume', m.counts({ eye: [5, 1], lamp, boxes }, [9, 0]).around, 1);
        equal('07: straight down without caps: z-fail sees nothing', m.counts({ eye: [5, 2], lamp, boxes, capped: 0 }, [5, 0]).fail, 0);
        equal('07: straight down with caps', m.counts({ eye: [5, 2], lamp, boxes }, [5, 0]).fail, 1);
        let wrong = 0;
        for (let i = 0; i < 3000; i++) {
            const state = { lamp: [between(0, 14), between(4.9, 6.2)], eye: [between(0, 14), between(0.3, 4.4)], target: [between(0, 14), 0],
                boxes: [[between(1, 6), between(0.8, 4.2)], [between(7.2, 13), between(0.8, 4.2)]] };
            const inside = (box) => Math.abs(state.eye[0] - box[0]) < 0.55 && Math.abs(state.eye[1] - box[1]) < 0.4;
            if (state.boxes.some(inside)) continue;
            const { pass, fail, around, truth } = m.counts(state, m.seen(state));
            wrong += fail !== truth || pass + around !== truth;
        }
        equal('07: z-fail, and z-pass from the number around the eye, are the truth, 3000 times', wrong, 0);
    },
    async '08'(m) {
        near('08: x = 3, h = 4', m.formula({ x: 3, h: 4 }, 0), 0.2);
        near('08: never more than one half', m.formula({ x: 1e-9, h: 1 }, 0), 0.5, 1e-8);
        near('08: evenly, h = x: a quarter of the half circle', m.formula({ x: 1, h: 1 }, 1), 0.25);
        const state = { point: [2, 0], top: [3.2, 1.6], side: 200, spread: 1, pattern: 1 + Math.floor(between(0, 60)) }; // x = 1.2, h = 1.6
        near('08: 40000 rays by the cosine: 0.2', m.occlusion({ ...state, weight: 0 }), 0.2, 0.003);
        near('08: 40000 rays evenly: atan(4/3)/pi', m.occlusion({ ...state, weight: 1 }), Math.atan(4 / 3) / Math.PI, 0.003);
        all('08: directions have the length 1', 100, () => Math.hypot(...m.direction([next(), next()], 0)) - 1);
        const up = times(40000, () => m.direction([next(), next()], 0)[2]).reduce((a, b) => a + b) / 40000;
        near('08: the mean cosine is 2/3', up, 2 / 3, 0.005);
    },
    async '09'(m) {
        const box = m.caster(0), outline = (mesh, lamp) => m.edgeSet(m.litTriangles(mesh, lamp), false);
        equal('09: a box has 12 triangles', box.triangles.length, 12);
        equal('09: a closed mesh leaves no edge', m.edgeSet(box.triangles, false).length, 0);
        equal('09: one side lit, straight above: 4 edges', outline(box, [-0.2, 3, -0.2]).length, 4);
        equal('09: three sides lit: 6 edges', outline(box, [-3, 3, -3]).length, 6);
        equal('09: two sides lit: 6 edges', outline(box, [-3, 3, -0.2]).length, 6);
        equal('09: compared with direction, none goes', m.edgeSet(m.litTriangles(box, [-3, 3, -3]), true).length, 18);
        const odd = times(500, (i) => {
            const mesh = m.caster(i % 2), edges = outline(mesh, [between(-4, 4), between(-1, 4), between(-4, 4)]);
            return mesh.corners.some((_, corner) => edges.filter((edge) => edge.includes(corner)).length % 2);
        }).filter(Boolean).length;
        equal('09: an even number of edges at each corner, 500 times', odd, 0);
    },
    async '10'(m) {
        const state = { kind: 0, lamp: [0, 5], left: [-1, 2], right: [1, 2], tilt: 0, side: 1, count: 4 };
        near('10: v = (1, 2) under (0, 5): 5/3', m.flattened([1, 2], state).at[0], 5 / 3);
        near('10: w\' = H - h', m.flattened([1, 2], state).w, 3);
        near('10: over the lamp w\' < 0', m.flattened([1, 6], state).w, -1);
        near('10: a sun along (-1, 5): x + 2/5', m.flattened([1, 2], { ...state, kind: 1, lamp: [3, 5] }).at[0], 1.4);
        const [[a, b], [c, d]] = m.borders(state);
        near('10: penumbra s h/(H - h)', Math.abs(a - b), 2 / 3);
        near('10: umbra (a H - s h)/(H - h), a = 2', Math.min(c, d) - Math.max(a, b), 8 / 3);
        for (const count of [2, 4, 8]) near(`10: ${count} lamps, worst 1/(2n)`, m.worst({ ...state, count }), 1 / (2 * count), 0.005);
        all('10: the result lies on the plane and on the line', 200, () => {
            const any = { kind: Math.floor(between(0, 2)), tilt: between(-15, 15), lamp: [between(-4, 4), between(4, 5)] }, v = [between(-3, 3), between(1.5, 3)], { at } = m.flattened(v, any);
            const [nx, ny] = m.plane(any), [lx, ly, lw] = m.lightPoint(any), way = lw ? [lx - v[0], ly - v[1]] : [lx, ly];
            return Math.abs(nx * at[0] + ny * at[1]) + Math.abs((at[0] - v[0]) * way[1] - (at[1] - v[1]) * way[0]);
        }, 1e-9);
    },
    async '11'(m) {
        near('11: m = n', m.depth(0.5), 0);
        near('11: m = f', m.depth(10), 1);
        near('11: half at 2nf/(n + f)', m.depth(10 / 10.5), 0.5);
        equal('11: (3, -2) goes through +x', m.faceOf([3, -2]).name, '+x');
        equal('11: (1, -2) goes through -y', m.faceOf([1, -2]).name, '−y');
        near('11: its m', m.faceOf([1, -2]).m, 2);
        all('11: m does not jump at a seam', 100, () => { const x = between(0.1, 5); return m.faceOf([x, x * (1 + 1e-12)]).m - m.faceOf([x, x * (1 - 1e-12)]).m; });
        const state = { lamp: [5, 3], ball: [8, 3], texels: 4096 };
        near('11: the ball at distance 3, radius 0.6', m.nearest([1, 0], state), 2.4);
        near('11: the wall behind the lamp', m.nearest([-1, 0], state), 5);
        near('11: the middle of the first of two texels', m.texelWay([2, -1.9], 2)[1], -0.5);
        const wrong = times(2000, () => [between(0.1, 13.9), between(0.1, 5.9)]).filter((point) => {
            const way = [point[0] - 5, point[1] - 3];
            return (m.kept(way, state) < m.faceOf(way).m - 0.01) !== m.hidden(point, state);
        }).length;
        near('11: a fine cube map is the truth nearly everywhere', wrong / 2000, 0, 0.02);
    },
    async '12'(m) {
        const state = { lamp: [4, 2], board: [6, 1], luxels: 40, padding: 1, plates: 0 };
        near('12: straight under the lamp 1/h^2', m.irradiance(4, state), 0.25);
        near('12: at 45 degrees 1/(h^2 2 sqrt 2)', m.irradiance(6, state), 1 / (8 * Math.SQRT2));
        near('12: the bound 3 s^2/(8 h^2)', m.bound(state), 3 * 0.0625 / 32);
        for (const luxels of [40, 80]) {
            const one = { ...state, luxels }, found = m.worst(4 - 10 / luxels, 4 + 10 / luxels, one) / 0.25;
            near(`12: ${luxels} luxels: the bound holds and is nearly met`, found / m.bound(one), 0.95, 0.05);
        }
        near('12: black padding takes half at the border', m.looked(0, { ...state, padding: 0 }) / m.luxel(0, state), 0.5);
        near('12: filled padding takes nothing', m.looked(0, state) / m.luxel(0, state), 1);
        near('12: under the plate, 1.2 at half the height: 2.4 wide', m.irradiance(6.79 + 0, { ...state, lamp: [6, 2], board: [6, 1], plates: 1 }) + m.irradiance(7.19, { ...state, lamp: [6, 2], board: [6, 1], plates: 1 }), 0);
        near('12: beside it', Number(m.irradiance(7.21, { ...state, lamp: [6, 2], board: [6, 1], plates: 1 }) > 0), 1);
    },
    async '13'(m) {
        near('13: G(d) for a = 0', m.gathered(3, 0), 3);
        near('13: G(2) for a = 0.5: (1 - 1/e)/0.5', m.gathered(2, 0.5), 2 * (1 - Math.exp(-1)));
        near('13: a nearly 0', m.gathered(3, 1e-7), 3, 1e-5);
        // A level ray at y = 2 under a board at y = 4, the lamp at y = 6 above it: the shadow is 2 * 1.1 wide there.
        const scene = { eye: [0, 2], end: [10, 2], lamp: [5, 6], boards: [[5, 4]], loss: 0.3, steps: 4000, place: 0.5 };
        const pieces = m.pieces(scene);
        equal('13: two lit pieces', pieces.length, 2);
        near('13: it enters at 3.9', pieces[0][1], 3.9);
        near('13: it leaves at 6.1', pieces[1][0], 6.1);
        const e = (t) => Math.exp(-0.3 * t);
        near('13: the sum over lit pieces', m.exact(scene), (1 - e(3.9) + e(6.1) - e(10)) / 0.3);
        near('13: many steps', m.march(scene), m.exact(scene), 0.003);
        near('13: overlapping shadows are dark once', m.exact({ ...scene, boards: [[5, 4], [5, 3.99]] }), m.exact(scene), 0.02);
        near('13: an eye in the shadow', m.exact({ ...scene, eye: [5, 2] }), (e(1.1) - e(5)) / 0.3);
        all('13: many steps at random', 50, () => {
            const any = { ...scene, lamp: [between(1, 14), between(6.2, 7.2)], eye: [between(0.3, 5), between(0.4, 5.8)], end: [between(6, 14), 0], boards: times(2, () => [between(1, 14), between(1, 5.8)]) };
            return m.march(any) - m.exact(any);
        }, 0.02);
    },
    14(m) {
        const one = { side: 1.2, first: [0, 2], second: [0, 1], two: 0, search: 3, point: [0, 0] };
        all('14: one blocker at half height, its shadow ends at 0: 1/2 + x / S', 40, () => {
            const x = between(-0.7, 0.7);
            return m.truth(one, x) - Math.min(1, Math.max(0, 0.5 + x / 1.2));
        });
        all('14: one blocker, wherever it ends: the kernel is right', 60, () => {
            const any = { ...one, side: between(0.2, 2), first: [between(-2, 2), between(0.3, 2.9)] }, x = between(-3, 3);
            return m.filtered(any, x) - m.truth(any, x);
        });
        near('14: half a kernel at half of the height: S / 2', m.reach(1.2, 2), 0.6);
        near('14: nothing is found far right', m.meanBlocker(one, 10), 0);
        near('14: one plate everywhere', m.meanBlocker({ ...one, first: [9, 2] }, 0), 2);
        // Shadows that both end at 0, 1.2 and 0.4 wide: (1.2 - 0.4) / 8 of light is false.
        const two = { ...one, two: 1 }, step = 1e-3;
        near('14: two blockers, the false light', times(1600, (i) => (m.filtered(two, (i - 799.5) * step) - m.truth(two, (i - 799.5) * step)) * step).reduce((a, b) => a + b), 0.1, 1e-4);
    },
    15(m) {
        const state = { lambda: 1, count: 4, k: 0.3, far: [8, 0] };
        near('15: logarithmic borders double', m.borders(state)[3], 4);
        near('15: uniform borders are even', m.borders({ ...state, lambda: 0 })[1], 0.5 + 7.5 / 4);
        near('15: with lambda 1 all slices are as coarse', m.coarse(state, 0)[0], m.coarse(state, 3)[0]);
        all('15: the sphere is the smallest', 60, () => {
            const a = between(0.1, 4), b = a + between(0, 6), k = between(0.1, 1.5), [center, radius] = m.sphere(a, b, k);
            const reach = (c) => Math.max(Math.hypot(a - c, a * k), Math.hypot(b - c, b * k));
            return Math.abs(reach(center) - radius) + Math.max(0, radius - Math.min(...times(400, (i) => reach((i / 400) * 2 * b))));
        });
        all('15: no lambda is better than 1 at its worst begin', 40, () => {
            const narrow = { ...state, k: 0.15 }, any = { ...narrow, lambda: between(0, 1) };
            return Math.max(0, m.worst(narrow) - m.worst(any));
        });
    },
    16(m) {
        const state = { upper: [0, 3], lower: [5, 1], two: 0, width: 1, at: [0.25, 0], cut: 0 };
        near('16: a quarter of the filter sees the plate', m.truth(state), 0.75);
        all('16: one plate: the bound is the truth', 40, () => {
            const any = { ...state, upper: [between(-0.6, 0.6), between(1.6, 3.6)], width: between(0.3, 2), at: [between(-0.2, 0.2), 0] };
            return m.bound(any).light - m.truth(any);
        });
        // q = 1/4, a = 2, b = 1: 3/16 4 / (3/16 4 + 9/4) = 1/4, which is also a^2 / (a + 2 b)^2.
        near('16: light under two plates', m.bound({ ...state, two: 1 }).light, 0.25);
        near('16: the most of it', m.most({ ...state, two: 1 }), 0.25);
        near('16: a cut at that leaves nothing', m.bound({ ...state, two: 1, cut: 0.25 }).left, 0);
        all('16: no share bleeds more', 60, () => {
            const any = { ...state, two: 1, upper: [between(-1, 1), between(1.6, 3.6)], lower: [5, between(0.2, 1.5)] };
            return Math.max(0, m.bound(any).light - m.most(any));
        });
    },
};
