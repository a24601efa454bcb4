// The sound of the page: the graph of Web Audio that renders it, live and without a sound card.

const workletText = ["sound", "stroke", "bodies", "proxies", "modes", "compiled-modes", "bowing", "resonators", "meter"].map(
  name => document.getElementById(`${name}-code`).textContent).join("\n");

/// What the build made of src/instruments/page_sound. Null if it made nothing, or if the browser can't run it.
const compiledBytes = runnable(page.webassembly && decoded(page.webassembly, Uint8Array));

function runnable(bytes) {
  return bytes && globalThis.WebAssembly?.validate(bytes) ? bytes : null;
}

/// A node of Web Audio whose output is the pressure in pascals.
/// @param blows        {body, start in audio samples, force, participation}
/// @param webassembly  null: JavaScript computes the modes
async function resonatorsIn(context, blows, webassembly = compiledBytes) {
  // Not a blob: a page that is opened as a file may not load one here.
  await context.audioWorklet.addModule("data:text/javascript;charset=utf-8," + encodeURIComponent(workletText));
  return new AudioWorkletNode(context, "resonators", {
    numberOfInputs: 0,
    outputChannelCount: [page.listeners.length],
    processorOptions: {
      webassembly,
      tunings: bodies.map(tuningOf),
      proxies: bodies.map(proxyOf),
      stretchings: bodies.map(({stretching}) => stretching),
      largestRotation: page.largest_rotation,
      blows,
      shortestDelay: page.shortest_delay,
    },
  });
}

/// What the audio thread needs of a body's proxies.
function proxyOf(body) {
  const {proxies: levels, tension, friction, size, airDensity: density} = body;
  const listeners = body.channels.map(({position}) => position);
  return {levels, listeners, air: {density, speed: page.air.speed}, tuning: {tension, friction, size}};
}

/// A hammer strikes a point of a body along the inward normal.
function blowOn(index, point, hammer, rate) {
  const body = bodies[index];
  if (!point) throw new Error(`the blow misses ${body.name}`);
  return {body: index, level: body.level, force: hammerForce(hammer, rate), ...sharesOf(body, point, scaled(point.normal, -1))};
}

/// Shares of the modes, or of the masses of the proxy that sounds, in a force of 1 N on a point of the surface.
function sharesOf(body, point, direction) {
  return body.level === null ? {participation: participationOf(body, point, direction)}
                             : {loads: loadsOn(body.proxies[body.level], point.place, direction)};
}

/// Pressure of blows at the listener's channels, Pa, without a sound card.
/// @param blows  {time in s, body, origin and direction of a ray that meets its surface, hammer}
function renderOffline(blows, duration, rate, webassembly = compiledBytes) {
  return renderStrikes(blows.map(({time, body, origin, direction, hammer}) => ({
    ...blowOn(body, hit(bodies[body], origin, unit(direction)), hammer, rate),
    start: Math.round(time * rate),
  })), duration, rate, webassembly);
}

/// The same of blows as the audio thread takes them.
async function renderStrikes(strikes, duration, rate, webassembly = compiledBytes) {
  const context = new OfflineAudioContext(page.listeners.length, Math.round(duration * rate), rate);
  const node = await resonatorsIn(context, strikes, webassembly);
  node.connect(context.destination);
  const sound = await context.startRendering();
  return page.listeners.map((_, channel) => Array.from(sound.getChannelData(channel)));
}

/// What is heard: pressure times the volume. It starts again after an error.
class Sound {
  /// @param tell  is called with a text when the audio thread ends, and when a body vibrates too far for its model
  /// @param hear  is called with what the meter posts (meter.js), and the samples per second
  constructor(tell, hear) {
    this.tell = tell;
    this.hear = hear;
    this.gain = 1;
  }

  /// The context, running. Browsers allow sound only after the user did something.
  async start() {
    this.starting ??= this.begin().catch(error => {
      this.starting = null;
      throw error;
    });
    const context = await this.starting;
    await context.resume();
    return context;
  }

  async begin() {
    const context = new AudioContext({latencyHint: "interactive"}), node = await resonatorsIn(context, []);
    node.onprocessorerror = () => this.end(context);
    node.port.onmessage = ({data: {turned}}) => this.tell(`${bodies[turned].name} vibrates so strongly that its parts turn by more than ` +
      `${page.largest_rotation} rad: its pitch may be wrong by ten cents.`);
    this.volume = new GainNode(context, {gain: this.gain});
    this.analyser = new AnalyserNode(context, {fftSize: 8192, smoothingTimeConstant: 0.3});
    node.connect(this.volume).connect(this.analyser);
    this.volume.connect(context.destination);
    this.meter = new AudioWorkletNode(context, "meter", {numberOfOutputs: 0});
    this.volume.connect(this.meter);
    this.meter.port.onmessage = ({data}) => this.hear(data, context.sampleRate);
    this.node = node;
    return context;
  }

  end(context) {
    this.starting = this.node = this.analyser = this.volume = this.meter = null;
    context.close();
    this.tell("The sound has ended: an error in the audio thread. The next blow starts it again.");
  }

  /// To the audio thread (resonators.js), if it runs.
  send(message) {
    this.node?.port.postMessage(message);
  }

  setVolume(decibels) {
    this.gain = 10 ** (decibels / 20);
    if (this.volume) this.volume.gain.value = this.gain;
  }
}
