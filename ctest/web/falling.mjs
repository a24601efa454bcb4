// node falling.mjs: lets boxes fall, collide, slide and spin by the solver of the Sonic Explorer, without a browser, and prints what
// happened as JSON.
import fs from "node:fs";
import vm from "node:vm";

const source = name => fs.readFileSync(new URL(`../../src/${name}.js`, import.meta.url), "utf8");
const files = ["foundation/web/page/bodies", "foundation/web/page/camera",
               ...["matrices", "hull", "rigid_body", "touching", "impulses", "falling", "drop"].map(name => `instruments/explorer/page/${name}`)];
const names = "RigidBody, Hull, Falling, Drop, lift, plus, scaled, applied, cross, turnedOn, rowsOf";
const silent = "const bodies = []; class ContactSounds { step() { return []; } }";
const {bodies: ofThePage, RigidBody, Hull, Falling, Drop, lift, plus, scaled, applied, cross, turnedOn, rowsOf} =
  vm.runInNewContext(`${silent}\n${files.map(source).join("\n")}\n({bodies, ${names}})`);
const step = 1 / 240;  // s

/// The surface of a box about the origin, in squares; `n` to an edge.
function box(sizes, n = 6) {
  const vertices = [], triangles = [];
  for (const axis of [0, 1, 2]) {
    for (const side of [-1, 1]) {
      const first = vertices.length / 3, [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      for (let k = 0; k < (n + 1) ** 2; ++k) {
        const at = [0, 0, 0];
        [at[axis], at[u], at[v]] = [side / 2 * sizes[axis], (Math.floor(k / (n + 1)) / n - 0.5) * sizes[u], (k % (n + 1) / n - 0.5) * sizes[v]];
        vertices.push(...at);
      }
      for (let k = 0; k < n * n; ++k) {
        const a = first + Math.floor(k / n) * (n + 1) + k % n, b = a + n + 1;
        triangles.push(...(side > 0 ? [a, b, b + 1, a, b + 1, a + 1] : [a, b + 1, b, a, a + 1, b + 1]));
      }
    }
  }
  return {vertices: new Float32Array(vertices), triangles: new Uint32Array(triangles)};
}

/// Of a radius of 0.05 m: a box blown up.
function ball() {
  const {vertices, triangles} = box([2, 2, 2]), radii = Array.from(vertices, (_, i) => Math.hypot(...vertices.subarray(i - i % 3, i - i % 3 + 3)));
  return {vertices: vertices.map((part, i) => 0.05 * part / radii[i]), triangles};
}

function boxAt(sizes, mass, position, {turn = [0, 0, 0], ...motion} = {}) {
  const body = Object.assign(new RigidBody(box(sizes), mass), {position, ...motion});
  body.face(turnedOn(body.turn, turn));
  return body;
}

const sum = (bodies, part) => bodies.map(part).reduce(plus);
const momentum = ({bodies}) => sum(bodies, ({velocity, mass}) => scaled(velocity, mass));
const angular = ({bodies}) => sum(bodies, body => plus(body.momentum(), cross(body.position, scaled(body.velocity, body.mass))));
const energy = ({bodies, weight}) => bodies.reduce((all, body) => all + body.kineticEnergy() + body.mass * weight * body.position[2], 0);
const lowest = body => Math.min(...body.hull.points.map(point => body.toRoom(point)[2]));

/// Until all rests, or for a time (s): how the energy grew in any step, over that at the beginning; how deep a body was in the ground.
function run(falling, time) {
  const begin = energy(falling), seen = {grown: 0, deepest: 0, events: 0, seconds: 0};
  for (let before = begin; seen.seconds < time && !falling.isAtRest; seen.seconds += step) {
    seen.events += falling.step(step).length;
    const now = energy(falling);
    seen.grown = Math.max(seen.grown, (now - before) / Math.abs(begin));
    seen.deepest = falling.bodies.reduce((most, body) => Math.max(most, falling.ground - lowest(body)), seen.deepest);
    before = now;
  }
  return {...seen, rests: falling.isAtRest};
}

/// The events of each step for a time (s).
function told(falling, time) {
  return Array.from({length: Math.round(time / step)}, () =>
    falling.step(step).map(({contact, impulse, slip, roll}) => ({contact, impulse, slip: Math.hypot(...slip), roll})));
}

const still = {weight: 0};
const inertia = new RigidBody(box([0.3, 0.2, 0.1]), 2).inertia;

/// How far a point outside comes before it meets the largest face of a box that lies askew in its own coordinates, m.
const entered = () => {
  const rows = rowsOf(turnedOn([0, 0, 0, 1], [0.3, 0.5, 0.2])), {vertices, triangles} = box([0.3, 0.2, 0.1]);
  const askew = new Float32Array(vertices.length);
  for (let i = 0; i < vertices.length; i += 3) askew.set(applied(rows, vertices.subarray(i, i + 3)), i);
  const [from, way] = [[0.1, 0.05, 1], [0, 0, -1]].map(v => applied(rows, v));
  return new Hull({vertices: askew, triangles}, [0, 0, 0]).enter(from, way, 0.01).share;
};

const hit = () => {  // off the centres
  const falling = new Falling([boxAt([0.1, 0.1, 0.1], 1, [-0.5, 0.02, 0.1], {turn: [0.3, 0.5, 0.2], velocity: [2, 0, 0]}),
                               boxAt([0.2, 0.05, 0.3], 2, [0, 0, 0], {spin: [1, 2, 3]})], -Infinity, still);
  const before = [...momentum(falling), ...angular(falling)], ran = run(falling, 0.5);
  return {...ran, before, after: [...momentum(falling), ...angular(falling)]};
};

const headOn = () => {
  const bodies = [boxAt([0.1, 0.1, 0.1], 1, [-0.3, 0, 0], {velocity: [2, 0, 0]}), boxAt([0.1, 0.1, 0.1], 3, [0, 0, 0])];
  run(new Falling(bodies, -Infinity, {...still, bounce: 0.5}), 0.5);
  return bodies.map(({velocity}) => velocity);
};

const spun = () => {  // about the unstable axis
  const body = boxAt([0.3, 0.2, 0.1], 1, [0, 0, 0], {spin: [0.1, 10, 0.1]}), falling = new Falling([body], -Infinity, still);
  const before = body.momentum(), whole = energy(falling);
  run(falling, 10);
  return {before, after: body.momentum(), energy: energy(falling) / whole, spin: body.spin[1]};
};

const settled = [[0.4, 0.7, 0.1], [1.3, 0.2, 2.0], [0, 0.785, 0]].map(turn => {
  const body = boxAt([0.3, 0.2, 0.1], 1, [0, 0, 0.5], {turn}), ran = run(new Falling([body], 0), 20);
  const up = body.rows[2].map(Math.abs), face = up.indexOf(Math.max(...up));
  return {...ran, upright: up[face], height: body.position[2], half: [0.15, 0.1, 0.05][face]};
});

const slid = () => {
  const body = boxAt([0.2, 0.2, 0.05], 1, [0, 0, 0.025], {velocity: [1.5, 0, 0]});
  const falling = new Falling([body], 0, {friction: 0.3}), events = told(falling, 0.4);
  return {...run(falling, 5), way: body.position[0], events: events.flat()};
};

/// Without slip at the beginning.
const rolled = () => {
  const body = Object.assign(new RigidBody(ball(), 1), {position: [0, 0, 0.05], velocity: [1, 0, 0], spin: [0, 20, 0]});
  return {steps: told(new Falling([body], 0), 1)};
};

const bounced = () => {
  const body = boxAt([0.1, 0.1, 0.1], 1, [0, 0, 0.55]), falling = new Falling([body], 0, {bounce: 0.6});
  let highest = 0, touched = false;
  for (let n = 0; n < 240 && !(touched && body.velocity[2] < 0); ++n) {
    touched = falling.step(step).length > 0 || touched;
    if (touched) highest = Math.max(highest, body.position[2] - 0.05);
  }
  return highest;
};

/// A tile flies at a plate of 3 mm that is as good as fixed: how far it is above that afterwards.
const tunnelled = [1, 5, 20].flatMap(speed => [[0, 0, 0], [0.3, 0.5, 0.2], [1.2, 0.1, 0.3]].map(turn => {
  const tile = boxAt([0.1, 0.1, 0.005], 1, [0.02, 0.03, 0.3], {turn, velocity: [0, 0, -speed]});
  run(new Falling([tile, boxAt([0.3, 0.3, 0.003], 1e6, [0, 0, 0])], -Infinity, still), 0.5);
  return tile.position[2];
}));

const heap = () => {
  const bodies = Array.from({length: 7}, (_, n) => boxAt([0.1 + 0.02 * (n % 4), 0.1, 0.03 + 0.03 * (n % 3)], 0.3 + 0.1 * n,
    [0.03 * Math.sin(2.4 * n), 0.03 * Math.cos(2.4 * n), 0.2 + 0.15 * n], {turn: [n, 0.7 * n, 0.3]}));
  const begin = performance.now(), ran = run(new Falling(bodies, 0), 20);
  return {...ran, milliseconds: (performance.now() - begin) / (ran.seconds / step), lowest: Math.min(...bodies.map(({position}) => position[2]))};
};

/// The impacts of a box that falls flat: their impulses, and when they begin.
const impacts = () => {
  const falling = new Falling([boxAt([0.1, 0.1, 0.1], 2, [0, 0, 0.25])], 0, {bounce: 0.5});
  for (let n = 0; n < 240; ++n) {
    const events = falling.step(step);
    if (events.length) return {time: (n + events[0].moment) * step, events};
  }
  return null;
};

/// How far a vertex of each body is from where it lay, m, once it lies, as the next drop of the first body begins, and when that is over.
const twice = () => {
  ofThePage.push(...[[0, 0, 0.3], [1, 0, 0.3]].map(at => {  // about its middle
    const {vertices, triangles} = box([0.3, 0.2, 0.1]);
    return {vertices: vertices.map((part, i) => part + at[i % 3]), triangles, mass: 1};
  }));
  const fall = (poses, start) => {
    const drop = new Drop(null, poses, start, 0, 0.4, 48000), begin = drop.poses();
    while (!drop.isOver) drop.step();
    return [begin, drop.poses()];
  };
  const askew = rigid => rigid.forEach((body, n) => body.face(turnedOn(body.turn, [2 + n, 0.3, 0.5])));
  const [home, lying] = fall([], askew), [raised, landed] = fall(lying, ([first]) => lift([first], 0.2));
  const corner = ({vertices}, [a, b, c, , d, e, f, , g, h, i, , x, y, z]) => {
    const [u, v, w] = vertices;
    return [a * u + d * v + g * w + x, b * u + e * v + h * w + y, c * u + f * v + i * w + z];
  };
  const way = (from, to) => ofThePage.map((body, n) => Math.hypot(...plus(corner(body, to[n]), scaled(corner(body, from[n]), -1))));
  return {fallen: way(home, lying), raised: way(lying, raised), landed: way(lying, landed)};
};

console.log(JSON.stringify({inertia, entered: entered(), hit: hit(), headOn: headOn(), spun: spun(), settled, slid: slid(), rolled: rolled(), bounced: bounced(), tunnelled, heap: heap(),
                            impacts: impacts(), twice: twice()}));
