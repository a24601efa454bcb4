// The page: sliders, the room, and the sound of the body that is struck.

class Explorer {
  constructor() {
    this.view = new View(element("room"), bodies);
    this.sound = new Sound(tell, (heard, rate) => this.hear(heard, rate));
    this.waveform = new Waveform(element("waveform"));
    this.views = new LatticeViews(element("views-canvas"), element("views-show"), element("views-legend"),
                                  (index, point) => this.strike(index, point));
    this.room = new Room(element("room"), this.view, (x, y) => this.strikeAt(x, y), new Scraping(this));
    this.chosen = 0;
    this.strikes = 0;
    this.dropping = new Dropping(this);
    this.workshop = new Workshop(this);
    this.connectSliders();
    this.choose(0);
    const frame = time => {
      this.dropping.advance();
      this.view.animate(time, this.chosen);
      this.showSpectrum(time);
      this.waveform.show(time);
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  hammer() {
    const read = id => 10 ** Number(element(id).value);
    return {mass: read("mass"), hardness: read("hardness"), speed: read("speed")};
  }

  setVolume() {
    element("volume-text").textContent = `${element("volume").value} dB`;
    this.sound.setVolume(Number(element("volume").value));
  }

  async strike(index, point) {
    this.choose(index);
    element("error").hidden = true;
    const {sampleRate} = await this.sound.start();
    this.sound.send({strike: blowOn(index, point, this.hammer(), sampleRate)});
    ++this.strikes;
    const {duration, peak} = hertzPulse(this.hammer());
    const place = point.place.map(coordinate => (1000 * coordinate).toFixed(0)).join(", ");
    element("blow").textContent =
      `${bodies[index].name} struck at (${place}) mm: ${peak.toPrecision(3)} N for ${(1000 * duration).toPrecision(3)} ms`;
  }

  async strikeAt(x, y) {
    const seen = pick(this.view, x, y);
    if (seen) await this.strike(seen.body, seen.point);
  }

  listBodies() {
    element("bodies").replaceChildren(...bodies.map((body, index) => {
      const button = document.createElement("button");
      button.textContent = body.name;
      button.onclick = () => this.choose(index);
      return button;
    }));
  }

  /// A new body, at the end of the list.
  add(body) {
    this.dropping.end();
    bodies.push(body);
    this.view.put(bodies.length - 1);
    this.sound.send({add: {tuning: tuningOf(body), proxies: proxyOf(body)}});
    this.choose(bodies.length - 1);
  }

  /// The chosen body becomes another one with as many modes. What rings goes on.
  replace(body) {
    this.dropping.end();
    const {size, friction} = bodies[this.chosen];
    bodies[this.chosen] = {...body, size, friction};
    this.view.put(this.chosen);
    this.retune();
  }

  choose(index) {
    this.chosen = index;
    if (element("bodies").children.length !== bodies.length) this.listBodies();
    [...element("bodies").children].forEach((button, i) => button.setAttribute("aria-pressed", i === index));
    const body = bodies[index];
    element("size").value = Math.log2(body.size);
    element("friction").value = Math.log10(body.friction);
    element("tension").value = Math.log2(body.tension);
    this.listLevels(body);
    element("mode").max = body.frequency.length;
    element("mode").value = Math.min(element("mode").value, body.frequency.length);
    element("views").hidden = bodies.every(({proxies}) => !proxies.length);
    this.views.draw();
    this.showNumbers();
    this.showMode();
    this.workshop.show(body.recipe);
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
    element("model").onchange = ({target}) => {
      bodies[this.chosen].level = target.value === "" ? null : Number(target.value);
      this.views.draw();
    };
    for (const id of ["size", "friction", "tension"]) element(id).oninput = () => this.retune();
    element("mode").oninput = () => this.showMode();
    element("volume").oninput = () => this.setVolume();
    this.setVolume();
  }

  retune() {
    const body = bodies[this.chosen];
    body.size = 2 ** Number(element("size").value);
    body.friction = 10 ** Number(element("friction").value);
    body.tension = 2 ** Number(element("tension").value);
    this.showNumbers();
    this.showMode();
    this.sound.send({tune: {body: this.chosen, ...tuningOf(body)}, tuneProxy: {body: this.chosen, ...proxyOf(body).tuning}});
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

  /// At most twenty times a second: the eye needs no more.
  /// @param time  ms
  showSpectrum(time) {
    const {analyser} = this.sound, body = bodies[this.chosen];
    if ((!analyser && !this.marksChanged) || time - this.spectrumTime < 50) return;
    this.spectrumTime = time;
    drawSpectrum(element("spectrum"), analyser, Array.from(body.frequency, (_, mode) => frequencyOf(body, mode)));
    this.marksChanged = false;
  }

  /// A sign for two seconds where samples are cut off.
  hear({peak, ranges}, rate) {
    this.waveform.add(ranges, rate);
    if (peak <= 1) return;
    element("clipping").hidden = false;
    clearTimeout(this.clipping);
    this.clipping = setTimeout(() => element("clipping").hidden = true, 2000);
  }
}

try {
  if (!bodies.length) bodies.push(madeBody("string", {kind: "string", ...recipes.string, position: [0, 0, 0]}));
  window.idiophone = {explorer: new Explorer(), renderOffline, bodies};
} catch (error) {
  tell(error.message);
  throw error;
}
