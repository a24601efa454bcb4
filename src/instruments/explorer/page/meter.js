// The audio thread: what goes to the loudspeakers, for signs and pictures. Runs after resonators.js in an AudioWorklet.

/// Posts for each 2048 samples the largest magnitude of any channel, of which is cut off what is above 1, and the ranges
/// [least, greatest, ...] of each 512 samples.
class Meter extends AudioWorkletProcessor {
  constructor() {
    super();
    this.ranges = [0, 0];
  }

  process([channels]) {
    const last = this.ranges.length - 2;
    for (const samples of channels) {
      for (const sample of samples) {
        this.ranges[last] = Math.min(this.ranges[last], sample);
        this.ranges[last + 1] = Math.max(this.ranges[last + 1], sample);
      }
    }
    if (currentFrame % 2048 === 0) {
      this.port.postMessage({peak: this.ranges.reduce((most, value) => Math.max(most, Math.abs(value)), 0), ranges: this.ranges});
      this.ranges = [0, 0];
    } else if (currentFrame % 512 === 0) {
      this.ranges.push(0, 0);
    }
    return true;
  }
}

registerProcessor("meter", Meter);
