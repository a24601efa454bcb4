// The audio thread: the modes of all bodies as resonators. Runs after sound.js in an AudioWorklet.

/// One body: its modes, the forces that act on it, and its sound on the way to the listener's channels.
class Voice {
  /// @param tuning    frequency [modes] Hz and decay [modes] 1/s; pressure [channels][2 x modes] Pa for a modal velocity
  ///                  of 1 m sqrt(kg)/s, and delay [channels] s
  /// @param shortestDelay  audio samples: nearer channels hear it as late
  constructor(tuning, shortestDelay) {
    this.shortestDelay = shortestDelay;
    this.modes = tuning.frequency.length;
    this.real = new Float64Array(this.modes);
    this.imaginary = new Float64Array(this.modes);
    this.drives = [];
    this.sounding = false;
    this.arrivals = tuning.delay.map(() => new Arrivals());
    this.tune(tuning);
  }

  /// @param tuning  of as many modes as before. Those that can't sound at the sampling rate rest.
  tune({frequency, decay, pressure, delay}) {
    this.resonators = Array.from(frequency, (hertz, mode) =>
      canSound(hertz, decay[mode], sampleRate) ? resonator(hertz, decay[mode], sampleRate) : null);
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
    this.arrivals.forEach((one, channel) => one.setDelay(Math.max(delay[channel] * sampleRate, this.shortestDelay)));
  }

  /// @param blow  start, audio sample; force by hammerForce(); participation [modes] 1/sqrt(kg)
  strike(blow) {
    this.drives.push(blow);
    this.sounding = true;
  }

  /// Adds what arrives at the channels in a block that begins at the audio sample `first`.
  render(first, channels) {
    const samples = channels[0].length;
    if (this.sounding) {
      const emitted = channels.map(() => new Float64Array(samples));
      this.advance(first, samples, emitted);
      emitted.forEach((sound, channel) => sound.forEach((value, i) => this.arrivals[channel].add(first + i, value)));
      this.quieten(first + samples);
    }
    channels.forEach((out, channel) => {
      for (let i = 0; i < samples; ++i) out[i] += this.arrivals[channel].take(first + i);
    });
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
    drive.rise ??= new SmoothRise(Math.min(...this.resonators.filter(Boolean).map(({damped}) => damped)), sampleRate);
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

/// Messages: {add: {tuning, proxies}}, {tune: {body, ...}}, {tuneProxy: {body, tension, friction, size}}, {strike: {body, level, start, ...}}:
/// level null for the modes; start in audio samples, or null for at once; {stroke: {id, ...}} (stroke.js), {follow: {id, news}} and
/// {lift: id}.
class Resonators extends AudioWorkletProcessor {
  constructor({processorOptions: {tunings, proxies, blows, shortestDelay}}) {
    super();
    this.shortestDelay = shortestDelay;
    this.voices = [];
    this.proxies = [];
    this.strokes = new Map();
    tunings.forEach((tuning, body) => this.add({tuning, proxies: proxies[body]}));
    blows.forEach(blow => this.struck(blow).strike(blow));
    this.port.onmessage = ({data}) => this.obey(data);
  }

  obey({add, tune, tuneProxy, strike, stroke, follow, lift}) {
    if (add) this.add(add);
    if (tune) this.voices[tune.body].tune(tune);
    if (tuneProxy) this.proxies[tuneProxy.body].forEach(voice => voice.tune(tuneProxy));
    if (strike) this.struck(strike).strike({...strike, start: Math.max(strike.start ?? 0, currentFrame)});
    if (stroke) this.strokes.set(stroke.id, new Stroke(stroke, sampleRate));
    if (follow) this.strokes.get(follow.id)?.follow(follow.news);
    if (lift !== undefined) this.strokes.get(lift)?.end();
  }

  add({tuning, proxies}) {
    this.voices.push(new Voice(tuning, this.shortestDelay));
    this.proxies.push(proxies.levels.map(level => new ProxyVoice(level, {...proxies, shortestDelay: this.shortestDelay})));
  }

  struck({body, level}) {
    return level === null ? this.voices[body] : this.proxies[body][level];
  }

  process(inputs, [channels]) {
    for (const [id, stroke] of this.strokes) {
      stroke.blows(currentFrame, channels[0].length).forEach(blow => this.struck(stroke).strike(blow));
      if (stroke.isOver) this.strokes.delete(id);
    }
    for (const voice of [...this.voices, ...this.proxies.flat()]) voice.render(currentFrame, channels);
    return true;
  }
}

registerProcessor("resonators", Resonators);
