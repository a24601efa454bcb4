// Mass-spring proxies in the audio thread, by the formulas of `idiophone proxies`. Runs after sound.js and bodies.js.

const recentDistance = 1e-10;  // m: a proxy whose masses move less is stable

/// The smallest number of equal steps in an interval with which no oscillator up to an angular frequency grows: both
/// eigenvalues of a step of symplectic Euler are in the unit circle (Jury's criterion).
function stableSteps(largest, {mass, stiffness}, interval) {
  for (let steps = 1; ; ++steps) {
    const step = interval / steps;
    let stable = true;
    for (let w = largest; stable && w > 1e-3 * largest; w *= 0.5) {
      const keep = 1 - step * (mass + stiffness * w * w);  // the determinant
      stable = Math.abs(keep) <= 1 && Math.abs(1 + keep - (step * w) ** 2) <= 1 + keep;
    }
    if (stable) return steps;
  }
}

/// What a blow does to each mass of a level for a force of 1 N, [3 x masses] N: shares at the triangle where the ray from
/// the centre through the place leaves the surface, or at a mass that is nearer; on a free body, less the forces that would
/// move it rigidly.
function loadsOn(level, place, direction) {
  const node = i => [level.nodes[3 * i], level.nodes[3 * i + 1], level.nodes[3 * i + 2]];
  const ray = minus(place, level.centre);
  let best = Infinity, corners = null, shares = null;
  for (let t = 0; t < level.surface.length; t += 3) {
    const ids = [...level.surface.subarray(t, t + 3)], [a, b, c] = ids.map(node);
    const first = minus(b, a), second = minus(c, a), normal = cross(first, second);
    const towards = dot(ray, normal);
    const distance = towards ? dot(minus(a, level.centre), normal) / towards : -1;
    const apart = Math.abs(distance - 1) * Math.hypot(...ray);
    if (distance < 0 || !(apart < best)) continue;
    const at = [0, 1, 2].map(axis => level.centre[axis] + distance * ray[axis]);
    const way = minus(at, a), square = dot(normal, normal);
    const v = dot(cross(way, second), normal) / square, w = dot(cross(first, way), normal) / square;
    if (v < -1e-9 || w < -1e-9 || v + w > 1 + 1e-9) continue;
    best = apart;
    corners = ids;
    shares = [a, b, c].map(corner => 1 / Math.max(Math.hypot(...minus(corner, at)), 1e-300));
  }
  for (const i of level.surface) {
    const apart = Math.hypot(...minus(node(i), place));
    if (apart >= best) continue;
    best = apart;
    corners = [i];
    shares = [1];
  }
  const sum = shares.reduce((a, b) => a + b), loads = new Float64Array(level.nodes.length);
  corners.forEach((i, n) => direction.forEach((part, axis) => loads[3 * i + axis] += shares[n] / sum * part));
  if (level.free) removeRigidPart(level, node, loads);
  return loads;
}

function removeRigidPart(level, node, loads) {
  let force = [0, 0, 0], torque = [0, 0, 0];
  const add = (a, b) => a.map((value, axis) => value + b[axis]);
  for (let i = 0; i < level.mass.length; ++i) {
    const load = [loads[3 * i], loads[3 * i + 1], loads[3 * i + 2]];
    force = add(force, load);
    torque = add(torque, cross(minus(node(i), level.centre), load));
  }
  const total = level.mass.reduce((a, b) => a + b);
  const turning = [0, 1, 2].map(row => dot(level.inverseInertia.slice(3 * row, 3 * row + 3), torque));
  for (let i = 0; i < level.mass.length; ++i) {
    const turned = cross(turning, minus(node(i), level.centre));
    for (let axis = 0; axis < 3; ++axis) loads[3 * i + axis] -= level.mass[i] * (force[axis] / total + turned[axis]);
  }
}

/// Half an area, shared by its corners, of the triangles towards a listener, [3 x masses] m2.
function facingWeights(level, listener) {
  const weights = new Float64Array(level.nodes.length), towards = minus(listener, level.centre);
  for (let t = 0; t < level.surface.length; t += 3) {
    const ids = level.surface.subarray(t, t + 3), [a, b, c] = Array.from(ids, i => level.nodes.subarray(3 * i, 3 * i + 3));
    const area = scaled(cross(minus(b, a), minus(c, a)), 0.5);
    if (dot(area, towards) > 0) ids.forEach(i => area.forEach((part, axis) => weights[3 * i + axis] += part / 3));
  }
  return weights;
}

/// One body at one level of detail.
class ProxyVoice {
  /// @param level  of readBody()
  /// @param body   its listeners [channels] m, the air {density kg/m3, speed m/s}, the shortest delay in audio samples, and
  ///               tuning {tension, friction, size}
  constructor(level, {listeners, air, shortestDelay, tuning}) {
    this.level = level;
    const length = level.nodes.length;
    for (const field of ["u", "v", "effective", "force"]) this[field] = new Float64Array(length);
    this.directions = new Float64Array(3 * level.a.length);  // times the root of the stiffness
    for (let s = 0; s < level.a.length; ++s) {
      const [a, b] = [level.a[s], level.b[s]].map(i => level.nodes.subarray(3 * i, 3 * i + 3));
      const way = minus(b, a);
      scaled(way, Math.sqrt(level.stiffness[s]) / Math.hypot(...way)).forEach((part, axis) => this.directions[3 * s + axis] = part);
    }
    this.channels = listeners.map(listener => {
      const distance = Math.hypot(...minus(listener, level.centre)), arrivals = new Arrivals();
      arrivals.setDelay(Math.max(distance / air.speed * sampleRate, shortestDelay));
      const gain = air.density * sampleRate / (2 * Math.PI * Math.max(0.01, distance));
      return {weights: facingWeights(level, listener), gain, before: 0, arrivals};
    });
    this.blows = [];
    this.sounding = false;
    this.tune(tuning);
  }

  tune({tension, friction, size}) {
    this.tension = tension / (size * size);
    this.mobility = 1 / size;
    this.damping = {mass: friction * this.level.damping.mass, stiffness: friction * this.level.damping.stiffness};
    this.steps = stableSteps(Math.sqrt(this.tension) * this.level.largest, this.damping, 1 / sampleRate);
    this.findEffective();
  }

  /// @param blow  start, audio sample; force by hammerForce(); loads by loadsOn()
  strike(blow) {
    this.blows.push(blow);
    this.sounding = true;
  }

  findEffective() {
    for (let i = 0; i < this.u.length; ++i) this.effective[i] = this.tension * (this.u[i] + this.damping.stiffness * this.v[i]);
  }

  step(step, acting) {
    const {u, v, effective, force, directions, level: {a, b, inverseMass}, damping, tension} = this;
    force.fill(0);
    for (const {newtons, loads} of acting) {
      for (let i = 0; i < force.length; ++i) force[i] += newtons * loads[i];
    }
    for (let s = 0; s < a.length; ++s) {
      const i = 3 * a[s], j = 3 * b[s], x = directions[3 * s], y = directions[3 * s + 1], z = directions[3 * s + 2];
      const pull = x * (effective[j] - effective[i]) + y * (effective[j + 1] - effective[i + 1]) + z * (effective[j + 2] - effective[i + 2]);
      force[i] += pull * x;
      force[i + 1] += pull * y;
      force[i + 2] += pull * z;
      force[j] -= pull * x;
      force[j + 1] -= pull * y;
      force[j + 2] -= pull * z;
    }
    for (let i = 0; i < u.length; ++i) {
      v[i] += step * (inverseMass[i / 3 | 0] * force[i] - damping.mass * v[i]);
      u[i] += step * v[i];
      effective[i] = tension * (u[i] + damping.stiffness * v[i]);
    }
  }

  /// Adds what arrives at the channels in a block that begins at the audio sample `first`.
  render(first, outputs) {
    if (this.sounding) this.emit(first, outputs[0].length);
    this.channels.forEach(({arrivals}, channel) => {
      for (let i = 0; i < outputs[channel].length; ++i) outputs[channel][i] += arrivals.take(first + i);
    });
  }

  emit(first, samples) {
    const step = 1 / (sampleRate * this.steps);
    for (let i = 0; i < samples; ++i) {
      const acting = this.blows.map(({start, force, loads}) => ({newtons: this.mobility * (force.mean[first + i - start] ?? 0), loads}))
        .filter(({newtons}) => newtons);
      for (let n = 0; n < this.steps; ++n) this.step(step, acting);
      this.channels.forEach(channel => {
        let sum = 0;
        for (let k = 0; k < this.v.length; ++k) sum += channel.weights[k] * this.v[k];
        channel.arrivals.add(first + i, channel.gain * (sum - channel.before));
        channel.before = sum;
      });
    }
    this.quieten(first + samples);
  }

  quieten(now) {
    this.blows = this.blows.filter(({start, force}) => start + force.mean.length > now);
    const near = (values, scale) => values.every(value => Math.abs(scale * value) < recentDistance);
    if (this.blows.length || !near(this.u, 1) || !near(this.v, 1 / sampleRate)) return;
    for (const field of [this.u, this.v, this.effective]) field.fill(0);
    this.channels.forEach(channel => channel.before = 0);
    this.sounding = false;
  }
}
