// A drop: how the bodies of the page fall, and the blows that they get by it.

const dropStep = 1 / 240;     // s
const longestDrop = 30;       // s
const stone = {young: 5e10, poisson: 0.2, radius: 1e3, height: 1e-5, friction: 0.4};  // the ground

/// How a body touches: its material, or steel where it has none, and edges of this radius.
const surfaceOf = ({young = 2e11, poisson = 0.3}) => ({young, poisson, radius: 5e-3, height: 1e-6, friction: 0.4});

class Drop {
  /// @param code    loadedCode()
  /// @param poses   where the bodies lie, as View has it
  /// @param start   is called with the rigid bodies, and puts them where they begin
  /// @param ground  m
  constructor(code, poses, start, ground, bounce, rate) {
    this.rigid = bodies.map(body => new RigidBody(body, body.mass));
    this.rigid.forEach((body, index) => poses[index] && layDown(body, poses[index]));
    start(this.rigid);
    this.falling = new Falling(this.rigid, ground, {bounce});
    this.sounds = new ContactSounds(code, [stone, ...bodies.map(surfaceOf)], rate);
    this.rate = rate;
    this.steps = 0;  // so far
  }

  get isOver() {
    return this.falling.isAtRest || this.steps * dropStep > longestDrop;
  }

  /// @return blows, as the audio thread takes them, with audio samples from the beginning of the drop
  step() {
    const events = this.falling.step(dropStep).map(event => ({...event, surfaces: event.bodies.map(body => body + 1)}));
    const forces = this.sounds.step(events, Math.round(this.steps++ * dropStep * this.rate), dropStep);
    return forces.flatMap(force => strikesOf(force, this.rigid));
  }

  /// Of the bodies, as View has it.
  poses() {
    return this.rigid.map(poseOf);
  }
}

/// As View has it.
function poseOf({rows, position, origin}) {
  const [x, y, z] = transposed(rows), at = minus(position, applied(rows, origin));
  return new Float32Array([...x, 0, ...y, 0, ...z, 0, ...at, 1]);
}

/// Puts a body where it has such a pose.
function layDown(body, pose) {
  const [x, y, z, at] = [0, 4, 8, 12].map(first => pose.subarray(first, first + 3));
  body.face(turnOf(transposed([x, y, z])));
  body.position = plus(at, applied(body.rows, body.origin));
}

/// Higher, and a little askew.
function lift(rigid, height) {
  rigid.forEach(body => {
    body.position = plus(body.position, [0, 0, height]);
    body.face(turnedOn(body.turn, [0, 1, 2].map(() => 0.4 * (Math.random() - 0.5))));
  });
}

/// One above the other about the middle of the room, the largest first, turned at random.
/// @param bottom  of the lowest one, m
function heap(rigid, bottom) {
  const middle = scaled(rigid.reduce((sum, {position}) => plus(sum, position), [0, 0, 0]), 1 / rigid.length);
  let top = bottom;
  [...rigid].sort((a, b) => b.reach - a.reach).forEach((body, n) => {
    const aside = 0.3 * body.reach;
    body.position = [middle[0] + aside * Math.cos(2.4 * n), middle[1] + aside * Math.sin(2.4 * n), top + body.reach];
    body.face(turnedOn(body.turn, [0, 1, 2].map(() => 3 * (Math.random() - 0.5))));
    top += 1.2 * body.reach;
  });
}
