"use strict";
// The sound of blows, by the formulas of `idiophone play`: resonators, the force of a hammer, and the delay to a
// listener. This file runs in the page and in the audio thread.

/// What one mode does in an audio sample: z becomes turn z + phi (byMean mean + bySlope slope). Complex numbers are
/// [real, imaginary]. z' = (i w - d) z + phi F, exact for a force that is linear in the sample.
function resonator(frequency, decay, rate) {
  const angular = 2 * Math.PI * frequency;
  const damped = Math.sqrt(angular * angular - decay * decay);
  const x = [-decay / rate, damped / rate];
  const size = Math.exp(x[0]);
  const turn = [size * Math.cos(x[1]), size * Math.sin(x[1])];
  const [mean, slope] = integrals(x, turn);
  return {
    turn,
    byMean: [mean[0] / rate, mean[1] / rate],
    bySlope: [slope[0] / rate, slope[1] / rate],
    velocity: [1, decay / damped],  // the modal velocity is Re(velocity z)
    damped,                         // rad/s
    // The state in which a mode follows a slow force, for 1 N and for each N/s by which it rises.
    staticState: over([-1 / rate, 0], x),
    risingState: over([-1 / (rate * rate), 0], times(x, x)),
  };
}

/// Whether a mode vibrates at a frequency that a sampling rate can hold.
function canSound(frequency, decay, rate) {
  return frequency < rate / 2 && decay < 2 * Math.PI * frequency;
}

/// Rate of change of a force, N/s, that passed a low-pass of first order, because modes do not follow what is fast. The force
/// is linear in each sample.
class SmoothRise {
  /// @param angular  frequency of the low-pass, rad/s: that of the lowest mode
  constructor(angular, rate) {
    this.angular = angular;
    this.turn = Math.exp(-angular / rate);
    const [[mean], [slope]] = integrals([-angular / rate, 0], [this.turn, 0]);
    this.byMean = mean * angular / rate;
    this.bySlope = slope * angular / rate;
    this.smooth = 0;
  }

  at(force) {
    return this.angular * (force - this.smooth);
  }

  advance(mean, slope) {
    this.smooth = this.turn * this.smooth + this.byMean * mean + this.bySlope * slope;
  }
}

function times(a, b) {
  return [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
}

function over(a, b) {
  const square = b[0] * b[0] + b[1] * b[1];
  return [(a[0] * b[0] + a[1] * b[1]) / square, (a[1] * b[0] - a[0] * b[1]) / square];
}

/// Integrals over a sample of exp(x (1 - s)) and (2 s - 1) exp(x (1 - s)), s from 0 to 1.
/// @param turn  exp(x)
function integrals(x, turn) {
  if (Math.hypot(x[0], x[1]) >= 0.1) {
    const mean = over([turn[0] - 1, turn[1]], x);
    const half = over([mean[0] - 1, mean[1]], x);
    return [mean, [2 * half[0] - mean[0], 2 * half[1] - mean[1]]];
  }
  const mean = [0, 0], slope = [0, 0];  // the closed form would lose digits
  let power = [1, 0];
  for (let n = 0; n < 12; ++n) {  // x^n/(n + 1)! and -n x^n/(n + 2)!
    for (const part of [0, 1]) {
      mean[part] += power[part] / (n + 1);
      slope[part] -= power[part] * (n / ((n + 1) * (n + 2)));
      power[part] /= n + 1;
    }
    power = times(power, x);
  }
  return [mean, slope];
}

/// Force of a rigid hammer with a round head by Hertz' law: its duration, s, and its peak, N.
/// @param hammer  mass in kg, hardness in N/m^(3/2), speed in m/s
function hertzPulse({mass, hardness, speed}) {
  const approach = Math.pow(1.25 * mass * speed * speed / hardness, 0.4);
  const duration = 0.8 * Math.sqrt(Math.PI) * 2.218159543757688 / 1.068628702119319 * approach / speed;
  const meanOfShape = 0.9064024770554771 / (Math.sqrt(Math.PI) * 0.9190625268488832);
  const peak = 2 * mass * speed / (meanOfShape * duration);
  return {duration, peak};
}

const gaussPoints = [[-0.8611363115940526, 0.34785484513745385], [-0.33998104358485626, 0.6521451548625461],
                     [0.33998104358485626, 0.6521451548625461], [0.8611363115940526, 0.34785484513745385]];

/// The force of a hammer in each audio sample, as the straight line with the same mean and first moment:
/// mean + slope (2 s - 1), N; begin is the force itself at the beginning of the sample.
function hammerForce(hammer, rate) {
  const {duration, peak} = hertzPulse(hammer);
  const samples = Math.ceil(duration * rate);
  const mean = new Float64Array(samples), slope = new Float64Array(samples), begin = new Float64Array(samples);
  const forceAt = time => time < duration ? peak * Math.pow(Math.sin(Math.PI * time / duration), 1.5) : 0;
  for (let n = 0; n < samples; ++n) {
    begin[n] = forceAt(n / rate);
    for (let quarter = 0; quarter < 4; ++quarter) {
      for (const [point, weight] of gaussPoints) {
        const s = (quarter + 0.5 * (1 + point)) / 4;
        const share = 0.125 * weight * forceAt((n + s) / rate);
        mean[n] += share;
        slope[n] += 3 * (2 * s - 1) * share;
      }
    }
  }
  return {mean, slope, begin};
}

/// Modified Bessel function of order 0.
function besselI0(x) {
  let sum = 1, term = 1;
  for (let n = 1; term > 1e-16 * sum; ++n) {
    term *= (0.5 * x / n) ** 2;
    sum += term;
  }
  return sum;
}

const spreadingWidth = 80;                        // audio samples
const spreadingFirst = 1 - spreadingWidth / 2;    // relative to the last sample before the arrival

/// Weights of the samples around an arrival at a fraction of a sample: sin(pi x)/(pi x) in Kaiser's window. For a delay
/// that rests it is what the program does (listening/spreading.cpp): exact up to 0.45 of the rate.
function spreading(fraction) {
  const shape = 0.1102 * (110 - 8.7);
  const weights = [...Array(spreadingWidth).keys()].map(tap => {
    const x = tap + spreadingFirst - fraction;
    const sinc = Math.abs(x) < 1e-9 ? 1 : Math.sin(Math.PI * x) / (Math.PI * x);
    return sinc * besselI0(shape * Math.sqrt(Math.max(0, 1 - (2 * x / spreadingWidth) ** 2)));
  });
  const sum = weights.reduce((a, b) => a + b);
  return weights.map(weight => weight / sum);
}

/// Sound on its way to one channel of the listener.
class Arrivals {
  constructor() {
    this.ring = new Float64Array(1);
  }

  /// From now on.
  /// @param samples  at least page.shortest_delay
  setDelay(samples) {
    this.before = Math.floor(samples);
    this.weights = spreading(samples - this.before);
    const length = 2 ** Math.ceil(Math.log2(this.before + spreadingWidth + 256));
    if (this.ring.length !== length) this.ring = new Float64Array(length);
  }

  /// @param sample  in which the pressure leaves
  add(sample, pressure) {
    for (let tap = 0; tap < spreadingWidth; ++tap) {
      this.ring[(sample + this.before + spreadingFirst + tap) & (this.ring.length - 1)] += pressure * this.weights[tap];
    }
  }

  /// What arrives in a sample; it is then forgotten.
  take(sample) {
    const place = sample & (this.ring.length - 1), pressure = this.ring[place];
    this.ring[place] = 0;
    return pressure;
  }
}
