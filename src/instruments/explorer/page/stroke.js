"use strict";
// The force of a tool that is drawn, or a ball that rolls, over a rough surface: that of src/instruments/resonators/stroke.cpp,
// with a speed and a load that change. This file runs in the page and in the audio thread.

const contactDamping = 0.1;     // ratio to critical, of the tool on its contact
const settlingTime = 0.01;      // s, in which speed and load follow what they shall be
const blendTime = 0.02;         // s, in which the force goes from one place to the next
const longestSilence = 0.06;    // s without news after which the tool rests

/// A rough profile as the tool feels it, with a height (root of the mean square) of 1: its heights at equally spaced points, and
/// their integral (m), so that means over any interval are differences. Waves with random phases, whose power falls as
/// 1/frequency^exponent; a contact of the size a feels a wave of wave number k by the factor exp(-(k a)^2/8).
/// @param roughness  exponent; longest and shortest wavelength, m
/// @param random     between 0 and 1, of the phases
function profileOf({exponent, longest, shortest}, size, random = Math.random) {
  const length = 16 * longest, points = 16384, heights = new Float64Array(points);
  let power = 0;
  for (let n = Math.ceil(length / longest); n <= length / shortest; ++n) {
    const wave = n ** (-exponent / 2), felt = Math.exp(-((2 * Math.PI * n / length * size) ** 2) / 8);
    power += 0.5 * wave ** 2;
    if (felt < 1e-5) continue;
    const [c, s] = [Math.cos(2 * Math.PI * n / points), Math.sin(2 * Math.PI * n / points)], phase = 2 * Math.PI * random();
    let [real, imaginary] = [wave * felt * Math.cos(phase), wave * felt * Math.sin(phase)];
    for (let i = 0; i < points; ++i) {
      heights[i] += real;
      [real, imaginary] = [c * real - s * imaginary, s * real + c * imaginary];
    }
  }
  const scaledHeights = Float64Array.from({length: points + 1}, (_, i) => heights[i % points] / Math.sqrt(power));
  const integral = new Float64Array(points + 1), half = 0.5 * length / points;
  for (let i = 0; i < points; ++i) integral[i + 1] = integral[i] + half * (scaledHeights[i] + scaledHeights[i + 1]);
  return {length, heights: scaledHeights, integral};
}

/// The force on the body, sample by sample.
class StrokeForce {
  /// @param tool  mass (kg), hardness (N/m^(3/2)), height of the roughness (m), and the profile
  constructor({mass, hardness, height, profile}, rate) {
    Object.assign(this, {mass, hardness, height, profile, rate});
    this.wanted = {load: 0, speed: 0};   // N and m/s
    this.load = this.speed = 0;          // as they are
    this.place = 0;                      // on the profile, m
    this.state = null;                   // of the tool on the spring of its contact; at first it rests on the profile
  }

  /// Integral of the profile from 0 to a place, m: heights are linear between the points.
  integralAt(place) {
    const {heights, integral, length} = this.profile, points = integral.length - 1, whole = Math.floor(place / length);
    const at = (place / length - whole) * points, i = Math.min(points - 1, Math.floor(at)), part = at - i;
    const within = part * heights[i] + 0.5 * part * part * (heights[i + 1] - heights[i]);
    return whole * integral[points] + integral[i] + length / points * within;
  }

  /// Mean height over the way of a sample, m.
  heightOver(way) {
    const before = this.place, touched = Math.max(way, 1e-9);
    this.place += way;
    return this.height * (this.integralAt(before + touched) - this.integralAt(before)) / touched;
  }

  /// The mean force in each of the next samples, N. The tool is a mass on the spring of Hertz' contact, linear about the load.
  next(samples) {
    const force = new Float64Array(samples), follow = 1 - Math.exp(-1 / (settlingTime * this.rate));
    const spring = 1.5 * this.hardness * Math.cbrt(Math.max(this.load, 1e-3 * this.wanted.load, 1e-9) / this.hardness);
    const angular = Math.sqrt(spring / this.mass), decay = contactDamping * angular;
    const {turn, byMean} = resonator(angular / (2 * Math.PI), decay, this.rate), pole = Math.sqrt(angular ** 2 - decay ** 2);
    // (2 d s + w^2)/(s^2 + 2 d s + w^2), by which the tool follows the profile, is 2 Re(residue/(s - p)), p = -d + i pole
    const residue = [decay, (2 * decay ** 2 - angular ** 2) / (2 * pole)];
    const follows = () => 2 * (residue[0] * this.state[0] - residue[1] * this.state[1]);
    for (let i = 0; i < samples; ++i) {
      this.load += follow * (this.wanted.load - this.load);
      this.speed += follow * (this.wanted.speed - this.speed);
      const height = this.heightOver(this.speed / this.rate);
      this.state ??= over([height, 0], [decay, -pole]);
      const before = follows(), turned = times(turn, this.state);
      this.state = [turned[0] + byMean[0] * height, turned[1] + byMean[1] * height];
      force[i] = Math.max(0, this.load + spring * (height - 0.5 * (before + follows())));
    }
    return force;
  }
}

/// A stroke in the audio thread: its force goes over from each place to the next.
class Stroke {
  /// @param start  body, level, tool, and news: load, speed, and the share of each mode or mass, {participation} or {loads}
  constructor({body, level, tool, news}, rate) {
    Object.assign(this, {body, level, rate});
    this.force = new StrokeForce(tool, rate);
    this.key = Object.keys(news.shares)[0];
    this.to = news.shares[this.key];
    this.follow(news);
  }

  follow({load, speed, shares}) {
    const share = Math.min(1, this.blend ?? 1);
    this.from = this.from ? this.to.map((value, i) => share * value + (1 - share) * this.from[i]) : this.to;
    this.to = shares[this.key];
    this.force.wanted = {load, speed};
    this.blend = 0;
    this.silence = 0;
  }

  /// The tool is lifted off.
  end() {
    this.force.wanted = {load: 0, speed: 0};
    this.ending = true;
  }

  get isOver() {
    return this.ending && this.force.load < 1e-6;
  }

  /// The blows (Voice.strike) that its force is in a block that begins at the audio sample `start`.
  blows(start, samples) {
    this.silence += samples / this.rate;
    if (this.silence > longestSilence) this.force.wanted.speed = 0;
    const force = this.force.next(samples), slope = new Float64Array(samples), there = new Float64Array(samples);
    for (let i = 0; i < samples; ++i) {
      this.blend = Math.min(1, this.blend + 1 / (blendTime * this.rate));
      there[i] = this.blend * force[i];
    }
    return [[this.from, force.map((newtons, i) => newtons - there[i])], [this.to, there]].map(
      ([shares, mean]) => ({start, force: {mean, slope, begin: mean}, [this.key]: shares}));
  }
}
