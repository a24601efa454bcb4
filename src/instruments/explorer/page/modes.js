"use strict";
// The modes of a body as resonators in JavaScript, for a program that was built without WebAssembly (compiled_modes.js). This
// file runs in the page and in the audio thread.

/// The modes and the forces that act on them.
class Modes {
  /// @param tuning  as tune()
  /// @param rate    audio samples per second
  constructor(tuning, rate) {
    this.rate = rate;
    this.modes = tuning.frequency.length;
    this.real = new Float64Array(this.modes);
    this.imaginary = new Float64Array(this.modes);
    this.drives = [];
    this.sounding = false;
    this.tune(tuning);
  }

  /// Those that can't sound at the sampling rate rest.
  /// @param tuning  frequency [modes] Hz and decay [modes] 1/s; pressure [channels][2 x modes] Pa for a modal velocity of
  ///                1 m sqrt(kg)/s. As many modes as before
  tune({frequency, decay, pressure}) {
    this.resonators = Array.from(frequency, (hertz, mode) =>
      canSound(hertz, decay[mode], this.rate) ? resonator(hertz, decay[mode], this.rate) : null);
    this.resonators.forEach((sounds, mode) => {
      if (!sounds) this.real[mode] = this.imaginary[mode] = 0;
    });
    this.gains = pressure.map(channel => {
      const gains = new Float64Array(2 * this.modes);
      for (let mode = 0; mode < this.modes; ++mode) {
        if (!this.resonators[mode]) continue;
        const gain = times([channel[2 * mode], channel[2 * mode + 1]], this.resonators[mode].velocity);
        gains[2 * mode] = gain[0];
        gains[2 * mode + 1] = gain[1];
      }
      return gains;
    });
    this.drives.forEach(drive => delete drive.following);
  }

  /// @param blow  start, audio sample; force by hammerForce(); participation [modes] 1/sqrt(kg)
  strike(blow) {
    this.drives.push(blow);
    this.sounding = true;
  }

  /// Pressure that leaves the body in the next samples, a list for each channel, or null if it is silent.
  /// @param first  audio sample
  render(first, samples) {
    if (!this.sounding) return null;
    const emitted = this.gains.map(() => new Float64Array(samples));
    this.advance(first, samples, emitted);
    this.quieten(first + samples);
    return emitted;
  }

  advance(first, samples, emitted) {
    const drives = this.drives.filter(drive => drive.start < first + samples);
    const acting = drives.filter(({start, force}) => start + force.mean.length > first);
    for (let mode = 0; mode < this.modes; ++mode) {
      if (!this.resonators[mode]) continue;
      const {turn: [turnReal, turnImaginary], byMean, bySlope} = this.resonators[mode];
      let real = this.real[mode], imaginary = this.imaginary[mode];
      for (let i = 0; i < samples; ++i) {
        for (let channel = 0; channel < emitted.length; ++channel) {
          emitted[channel][i] +=
            this.gains[channel][2 * mode] * real - this.gains[channel][2 * mode + 1] * imaginary;
        }
        const turned = turnReal * real - turnImaginary * imaginary;
        imaginary = turnReal * imaginary + turnImaginary * real;
        real = turned;
        for (const {start, force, participation} of acting) {
          const n = first + i - start;
          if (n >= 0 && n < force.mean.length) {
            real += participation[mode] * (byMean[0] * force.mean[n] + bySlope[0] * force.slope[n]);
            imaginary += participation[mode] * (byMean[1] * force.mean[n] + bySlope[1] * force.slope[n]);
          }
        }
      }
      this.real[mode] = real;
      this.imaginary[mode] = imaginary;
    }
    drives.forEach(drive => this.takeFollowingSound(drive, first, emitted));
  }

  /// Takes away what the modes do when they only follow a slow force (docs/method/sound_map.md).
  takeFollowingSound(drive, first, emitted) {
    drive.following ??= this.following(drive.participation);
    drive.rise ??= new SmoothRise(Math.min(...this.resonators.filter(Boolean).map(({damped}) => damped)), this.rate);
    const {start, force, following: {ofForce, ofRise}} = drive;
    for (let i = Math.max(0, start - first); i < emitted[0].length; ++i) {
      const n = first + i - start, begin = force.begin[n] ?? 0, rise = drive.rise.at(begin);
      emitted.forEach((sound, channel) => sound[i] -= begin * ofForce[channel] + rise * ofRise[channel]);
      drive.rise.advance(force.mean[n] ?? 0, force.slope[n] ?? 0);
    }
  }

  /// Their pressure at each channel, Pa for 1 N and for 1 N/s.
  following(participation) {
    const sounds = state => this.gains.map(gains => this.resonators.reduce((sum, one, mode) => sum +
      (one ? participation[mode] * times([gains[2 * mode], gains[2 * mode + 1]], one[state])[0] : 0), 0));
    return {ofForce: sounds("staticState"), ofRise: sounds("risingState")};
  }

  /// Forgets forces that are over. A body that nobody can hear any more stops.
  quieten(now) {
    this.drives = this.drives.filter(
      ({start, force, rise}) => start + force.mean.length > now || Math.abs(rise.smooth) > 1e-5 * Math.max(...force.mean));
    let energy = 0;
    for (let mode = 0; mode < this.modes; ++mode) {
      energy += this.real[mode] ** 2 + this.imaginary[mode] ** 2;
    }
    if (!this.drives.length && energy < 1e-30) {
      this.real.fill(0);
      this.imaginary.fill(0);
      this.sounding = false;
    }
  }
}
