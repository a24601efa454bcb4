// The audio thread: bodies as modes and as proxies. Runs after sound.js and others in an AudioWorklet.

/// One body: its modes, and its sound on the way to the listener's channels.
class Voice {
  /// @param modes          Modes or CompiledModes
  /// @param tuning         of the modes, and delay [channels] s
  /// @param shortestDelay  audio samples: nearer channels hear it as late
  constructor(modes, {delay}, shortestDelay) {
    this.modes = modes;
    this.shortestDelay = shortestDelay;
    this.arrivals = delay.map(() => new Arrivals());
    this.setDelays(delay);
  }

  tune(tuning) {
    this.modes.tune(tuning);
    this.setDelays(tuning.delay);
  }

  setDelays(delay) {
    this.arrivals.forEach((one, channel) => one.setDelay(Math.max(delay[channel] * sampleRate, this.shortestDelay)));
  }

  strike(blow) {
    this.modes.strike(blow);
  }

  /// Adds what arrives at the channels in a block that begins at the audio sample `first`.
  render(first, channels) {
    const samples = channels[0].length, emitted = this.modes.render(first, samples);
    emitted?.forEach((sound, channel) => sound.forEach((value, i) => this.arrivals[channel].add(first + i, value)));
    channels.forEach((out, channel) => {
      for (let i = 0; i < samples; ++i) out[i] += this.arrivals[channel].take(first + i);
    });
  }
}

/// Messages: {add: {tuning, proxies}}, {tune: {body, ...}}, {tuneProxy: {body, tension, friction, size}}, {strike: {body, level, start, ...}}:
/// level null for the modes; start in audio samples, or null for at once; {strikes: [strike, ...]}; {stroke: {id, kind, ...}} (stroke.js, bowing.js),
/// {follow: {id, news}} and {lift: id}.
class Resonators extends AudioWorkletProcessor {
  constructor({processorOptions: {webassembly, tunings, proxies, stretchings, largestRotation, blows, shortestDelay}}) {
    super();
    this.code = webassembly && compiledCode(webassembly);
    this.shortestDelay = shortestDelay;
    this.largestRotation = largestRotation;  // rad, at which stretched modes are still right
    this.voices = [];
    this.watched = new Map();  // numbers and modes of bodies whose vibrations may be large
    this.proxies = [];
    this.strokes = new Map();
    this.bows = 0;  // so far
    tunings.forEach((tuning, body) => this.add({tuning, proxies: proxies[body], stretching: stretchings[body]}));
    blows.forEach(blow => this.struck(blow).strike(blow));
    this.messages = [];
    this.port.onmessage = ({data}) => this.messages.push(data);
  }

  obey({add, tune, tuneProxy, strike, strikes, stroke, follow, lift}) {
    if (add) this.add(add);
    if (tune) this.voices[tune.body].tune(tune);
    if (tuneProxy) this.proxies[tuneProxy.body].forEach(voice => voice.tune(tuneProxy));
    for (const blow of strikes ?? (strike ? [strike] : [])) this.struck(blow).strike({...blow, start: Math.max(blow.start ?? 0, currentFrame)});
    if (stroke) this.strokes.set(stroke.id, this.begun(stroke));
    if (follow) this.strokes.get(follow.id)?.follow(follow.news);
    if (lift !== undefined) this.strokes.get(lift)?.end();
  }

  begun(stroke) {
    return stroke.kind === "bow" ? new Bowing(stroke, this.voices[stroke.body].modes, ++this.bows, sampleRate)
                                 : new Stroke(stroke, sampleRate);
  }

  /// Without WebAssembly, vibrations are those of small amplitudes.
  add({tuning, proxies, stretching}) {
    const modes = this.code ? new CompiledModes(this.code, tuning, sampleRate, stretching) : new Modes(tuning, sampleRate);
    if (this.code && stretching) this.watched.set(this.voices.length, modes);
    this.voices.push(new Voice(modes, tuning, this.shortestDelay));
    this.proxies.push(proxies.levels.map(level => new ProxyVoice(level, {...proxies, shortestDelay: this.shortestDelay})));
  }

  struck({body, level}) {
    return level === null ? this.voices[body] : this.proxies[body][level];
  }

  /// Tells once of each body that its parts turn too far.
  watchRotations() {
    for (const [turned, modes] of this.watched) {
      if (modes.rotation() > this.largestRotation) {
        this.port.postMessage({turned});
        this.watched.delete(turned);
      }
    }
  }

  process(inputs, [channels]) {
    // Here an error ends the thread, and the page says so. In onmessage it would be lost.
    this.messages.splice(0).forEach(message => this.obey(message));
    for (const [id, stroke] of this.strokes) {
      stroke.blows(currentFrame, channels[0].length).forEach(blow => this.struck(stroke).strike(blow));
      if (stroke.isOver) this.strokes.delete(id);
    }
    for (const voice of [...this.voices, ...this.proxies.flat()]) voice.render(currentFrame, channels);
    this.watchRotations();
    return true;
  }
}

registerProcessor("resonators", Resonators);
