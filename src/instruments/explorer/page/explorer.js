// The page: sliders, the room, and the sound of the body that is struck.

const page = JSON.parse(document.getElementById("data").textContent);  // as src/instruments/explorer/explorer_page.cpp writes it
const bodies = page.bodies.map(readBody);
const element = id => document.getElementById(id);
const workletText = ["sound-code", "bodies-code", "proxies-code", "resonators-code"].map(id => element(id).textContent).join("\n");

/// A graph of Web Audio whose output is the pressure in pascals.
/// @param blows  {body, start in audio samples, force, participation}
async function resonatorsIn(context, blows) {
  // Not a blob: a page that is opened as a file may not load one here.
  await context.audioWorklet.addModule("data:text/javascript;charset=utf-8," + encodeURIComponent(workletText));
  const tunings = bodies.map(body => tuningOf(body, context.sampleRate));
  return new AudioWorkletNode(context, "resonators", {
    numberOfInputs: 0,
    outputChannelCount: [bodies[0].channels.length],
    processorOptions: {tunings, proxies: bodies.map(proxyOf), blows, shortestDelay: page.shortest_delay},
  });
}

/// What the audio thread needs of a body's proxies.
function proxyOf(body) {
  const {proxies: levels, tension, friction, size, airDensity} = body;
  return {levels, listeners: body.channels.map(({position}) => position), airDensity, tuning: {tension, friction, size}};
}

/// A hammer strikes a point of a body along the inward normal.
function blowOn(index, point, hammer, rate) {
  const body = bodies[index];
  if (!point) throw new Error(`the blow misses ${body.name}`);
  const inward = scaled(point.normal, -1), blow = {body: index, level: body.level, force: hammerForce(hammer, rate)};
  return body.level === null ? {...blow, participation: participationOf(body, rate, point, inward)}
                             : {...blow, loads: loadsOn(body.proxies[body.level], point.place, inward)};
}

/// Pressure of blows at the listener's channels, Pa, without a sound card.
/// @param blows  {time in s, body, origin and direction of a ray that meets its surface, hammer}
async function renderOffline(blows, duration, rate) {
  const context = new OfflineAudioContext(bodies[0].channels.length, Math.round(duration * rate), rate);
  const node = await resonatorsIn(context, blows.map(({time, body, origin, direction, hammer}) => ({
    ...blowOn(body, hit(bodies[body], origin, unit(direction)), hammer, rate),
    start: Math.round(time * rate),
  })));
  node.connect(context.destination);
  const sound = await context.startRendering();
  return bodies[0].channels.map((_, channel) => Array.from(sound.getChannelData(channel)));
}

class Explorer {
  constructor() {
    this.view = new View(element("room"), bodies);
    this.chosen = 0;
    this.strikes = 0;
    this.listBodies();
    this.connectSliders();
    this.connectRoom();
    this.choose(0);
    const frame = time => {
      this.view.animate(time, this.chosen);
      if (this.analyser || this.marksChanged) this.drawSpectrum();
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  hammer() {
    const read = id => 10 ** Number(element(id).value);
    return {mass: read("mass"), hardness: read("hardness"), speed: read("speed")};
  }

  /// Browsers allow sound only after the user did something.
  async audio() {
    this.starting ??= (async () => {
      const context = new AudioContext({latencyHint: "interactive"});
      this.node = await resonatorsIn(context, []);
      this.volume = new GainNode(context);
      this.analyser = new AnalyserNode(context, {fftSize: 8192, smoothingTimeConstant: 0.3});
      this.node.connect(this.volume).connect(this.analyser);
      this.volume.connect(context.destination);
      this.setVolume();
      return context;
    })();
    const context = await this.starting;
    await context.resume();
    return context;
  }

  setVolume() {
    element("volume-text").textContent = `${element("volume").value} dB`;
    if (this.volume) this.volume.gain.value = 10 ** (Number(element("volume").value) / 20);
  }

  async strike(index, point) {
    this.choose(index);
    const context = await this.audio();
    this.node.port.postMessage({strike: blowOn(index, point, this.hammer(), context.sampleRate)});
    ++this.strikes;
    const {duration, peak} = hertzPulse(this.hammer());
    const place = point.place.map(coordinate => (1000 * coordinate).toFixed(0)).join(", ");
    element("blow").textContent =
      `${bodies[index].name} struck at (${place}) mm: ${peak.toPrecision(3)} N for ${(1000 * duration).toPrecision(3)} ms`;
  }

  async strikeAt(x, y) {
    const seen = this.view.pick(x, y);
    if (seen) await this.strike(seen.body, seen.point);
  }

  listBodies() {
    bodies.forEach((body, index) => {
      const button = document.createElement("button");
      button.textContent = body.name;
      button.onclick = () => this.choose(index);
      element("bodies").append(button);
    });
  }

  choose(index) {
    this.chosen = index;
    [...element("bodies").children].forEach((button, i) => button.setAttribute("aria-pressed", i === index));
    const body = bodies[index];
    element("size").value = Math.log2(body.size);
    element("friction").value = Math.log10(body.friction);
    element("tension").value = Math.log2(body.tension);
    this.listLevels(body);
    element("mode").max = body.frequency.length;
    element("mode").value = Math.min(element("mode").value, body.frequency.length);
    this.showNumbers();
    this.showMode();
  }

  /// What of a body sounds: its modes, or a proxy at a level of detail.
  listLevels(body) {
    const options = ["modes", ...body.proxies.map(({a, mass}, level) => `proxy, level ${level}: ${mass.length} masses, ${a.length} springs`)];
    element("model").replaceChildren(...options.map((text, n) => new Option(text, n ? n - 1 : "")));
    element("model").value = body.level ?? "";
    element("proxy").hidden = !body.proxies.length;
  }

  connectSliders() {
    for (const id of ["mass", "hardness", "speed"]) element(id).oninput = () => this.showNumbers();
    element("model").onchange = ({target}) => bodies[this.chosen].level = target.value === "" ? null : Number(target.value);
    for (const id of ["size", "friction", "tension"]) element(id).oninput = () => this.retune();
    element("mode").oninput = () => this.showMode();
    element("volume").oninput = () => this.setVolume();
    this.setVolume();
  }

  async retune() {
    const body = bodies[this.chosen];
    body.size = 2 ** Number(element("size").value);
    body.friction = 10 ** Number(element("friction").value);
    body.tension = 2 ** Number(element("tension").value);
    this.showNumbers();
    this.showMode();
    if (this.starting) {
      const context = await this.starting;
      this.node.port.postMessage({tune: {body: this.chosen, ...tuningOf(body, context.sampleRate)},
                                  tuneProxy: {body: this.chosen, ...proxyOf(body).tuning}});
    }
  }

  showNumbers() {
    const {mass, hardness, speed} = this.hammer(), body = bodies[this.chosen];
    element("mass-text").textContent = mass < 1 ? `${(1000 * mass).toPrecision(2)} g` : `${mass.toPrecision(2)} kg`;
    element("hardness-text").textContent = `${hardness.toExponential(1)} N/m^(3/2)`;
    element("speed-text").textContent = `${speed.toPrecision(2)} m/s`;
    element("size-text").textContent = `× ${body.size.toPrecision(3)}`;
    element("tension-text").textContent = `× ${body.tension.toPrecision(3)}`;
    element("friction-text").textContent = `× ${body.friction.toPrecision(2)}`;
  }

  showMode() {
    this.marksChanged = true;
    const mode = Number(element("mode").value) - 1, body = bodies[this.chosen];
    this.view.show(mode < 0 ? null : {body: this.chosen, mode});
    element("mode-text").textContent = mode < 0 ? "none" :
      `${mode + 1}: ${frequencyOf(body, mode).toFixed(1)} Hz, −60 dB after ${(6.908 / decayOf(body, mode)).toPrecision(2)} s`;
  }

  connectRoom() {
    const room = element("room"), touches = new Map();
    let moved = 0, spread = 0;
    room.onpointerdown = event => {
      room.setPointerCapture(event.pointerId);
      touches.set(event.pointerId, event);
      moved = touches.size > 1 ? Infinity : 0;
      spread = 0;
    };
    room.onpointermove = event => {
      const before = touches.get(event.pointerId);
      if (!before) return;
      touches.set(event.pointerId, event);
      if (touches.size === 2) {
        const [a, b] = [...touches.values()], apart = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
        if (spread) this.view.zoom(spread / apart);
        spread = apart;
        return;
      }
      const [right, down] = [event.clientX - before.clientX, event.clientY - before.clientY];
      moved += Math.hypot(right, down);
      if (moved > 6) this.view.turn(-0.008 * right, 0.008 * down);
    };
    room.onpointerup = room.onpointercancel = event => {
      const struck = touches.delete(event.pointerId) && event.type === "pointerup" && moved <= 6;
      const {left, top} = room.getBoundingClientRect();
      if (struck) this.strikeAt(event.clientX - left, event.clientY - top);
    };
    room.addEventListener("wheel", event => {
      event.preventDefault();
      this.view.zoom(Math.exp(0.001 * event.deltaY));
    }, {passive: false});
    room.onkeydown = event => this.onKey(event);
  }

  onKey(event) {
    const {clientWidth, clientHeight} = element("room");
    const actions = {
      ArrowLeft: () => this.view.turn(-0.08, 0), ArrowRight: () => this.view.turn(0.08, 0),
      ArrowUp: () => this.view.turn(0, 0.08), ArrowDown: () => this.view.turn(0, -0.08),
      "+": () => this.view.zoom(0.9), "-": () => this.view.zoom(1 / 0.9), Home: () => this.view.goHome(),
      Enter: () => this.strikeAt(clientWidth / 2, clientHeight / 2), " ": () => this.strikeAt(clientWidth / 2, clientHeight / 2),
    };
    if (actions[event.key]) {
      event.preventDefault();
      actions[event.key]();
    }
  }

  drawSpectrum() {
    this.marksChanged = false;
    const canvas = element("spectrum"), pen = canvas.getContext("2d");
    const {width, height} = canvas, top = 20000, bottom = 40;
    const x = hertz => width * Math.log(hertz / bottom) / Math.log(top / bottom);
    pen.clearRect(0, 0, width, height);
    pen.strokeStyle = "#ccc";
    pen.fillStyle = "#555";
    for (const [hertz, label] of [[100, "100 Hz"], [1000, "1 kHz"], [10000, "10 kHz"]]) {
      pen.strokeRect(x(hertz), 0, 0, height);
      pen.fillText(label, x(hertz) + 3, 10);
    }
    pen.fillStyle = "#b33";
    const body = bodies[this.chosen];
    for (let mode = 0; mode < body.frequency.length; ++mode) pen.fillRect(x(frequencyOf(body, mode)), height - 6, 1, 6);
    if (!this.analyser) return;
    const levels = new Float32Array(this.analyser.frequencyBinCount);
    this.analyser.getFloatFrequencyData(levels);
    pen.strokeStyle = "#246";
    pen.beginPath();
    levels.forEach((level, bin) => {
      const hertz = bin * this.analyser.context.sampleRate / this.analyser.fftSize;
      if (hertz >= bottom) pen.lineTo(x(hertz), height * Math.min(1, -Math.max(level, -140) / 140));
    });
    pen.stroke();
  }
}

try {
  window.idiophone = {explorer: new Explorer(), renderOffline, bodies};
} catch (error) {
  element("blow").textContent = error.message;
  throw error;
}
