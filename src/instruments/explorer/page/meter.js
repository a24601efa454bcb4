// The audio thread: how loud the sound is that goes to the loudspeakers. Runs after resonators.js in an AudioWorklet.

/// Posts the largest magnitude of each 2048 samples of any channel; what is above 1 is cut off.
class Meter extends AudioWorkletProcessor {
  constructor() {
    super();
    this.largest = 0;
  }

  process([channels]) {
    for (const samples of channels) {
      for (const sample of samples) this.largest = Math.max(this.largest, Math.abs(sample));
    }
    if (currentFrame % 2048 === 0) {
      this.port.postMessage(this.largest);
      this.largest = 0;
    }
    return true;
  }
}

registerProcessor("meter", Meter);
