// The page: fills it with the results, and connects what a user can change.

const data = JSON.parse(document.getElementById("data").textContent);
const element = id => document.getElementById(id);
const colours = ["#246", "#c60"];
const letters = ["A", "B"];

const results = data.results.map(result => ({
  ...result,
  channels: result.channels.map(readChannel),
  series: result.series.map(series => ({...series, times: decoded(series.times, Float32Array),
                                        values: decoded(series.values, Float32Array)})),
}));
const isPair = results.length === 2;
const labelOf = index => isPair ? `${letters[index]}: ${results[index].name}` : results[index].name;

function fill(table, heads, rows) {
  const line = (cells, tag) => {
    const row = document.createElement("tr");
    for (const cell of cells) {
      const item = document.createElement(tag);
      item.textContent = cell;
      row.append(item);
    }
    return row;
  };
  table.replaceChildren(line(heads, "th"), ...rows.map(cells => line(cells, "td")));
}

const fixed = (value, digits) => value === null || value === undefined ? "–" : value.toFixed(digits).replace("-", "−");

/// Cents from the nearest of some frequencies, within 100.
function centsFrom(frequency, frequencies) {
  const all = frequencies.map(reference => 1200 * Math.log2(frequency / reference));
  const nearest = all.reduce((best, cents) => Math.abs(cents) < Math.abs(best) ? cents : best, Infinity);
  return Math.abs(nearest) <= 100 ? nearest : null;
}

/// Names and values of nested objects, one by one.
function flat(object, path = "") {
  return Object.entries(object).flatMap(([key, value]) => {
    const name = path ? `${path} / ${key}` : key;
    if (value !== null && typeof value === "object") return flat(value, name);
    return [[name, typeof value === "number" ? short(value) : String(value)]];
  });
}

class Report {
  constructor() {
    this.spectra = new Spectra(element("spectrogram"), element("spectrum"));
    this.shown = 0;
    document.title = `Idiophone: ${results.map(({name}) => name).join(" and ")}`;
    element("title").textContent = results.map((_, index) => labelOf(index)).join("   ");
    this.addPlayers();
    this.connectSpectra();
    if (isPair) this.connectPair();
    this.choose(0);
  }

  addPlayers() {
    results.forEach((result, index) => {
      for (const [name, channels] of listenersOf(result.channels)) {
        addPlayer(element("players"), isPair ? `${letters[index]}: ${name}` : name, channels);
      }
    });
  }

  connectPair() {
    results.forEach((_, index) => {
      const button = document.createElement("button");
      button.textContent = labelOf(index);
      button.onclick = () => this.choose(index);
      element("results").append(button);
    });
    element("switch").hidden = false;
    element("comparison").hidden = false;
    this.two = new TwoSounds(results[0].channels[0], results[1].channels[0]);
    element("play").onclick = async () => {
      if (this.two.playing) {
        this.two.stop();
      } else {
        await this.two.play();
      }
      element("play").textContent = this.two.playing ? "Stop" : "Play both";
    };
    element("swap").onclick = () => {
      this.two.swap();
      element("swap").setAttribute("aria-pressed", this.two.heard === 1);
      element("swap").textContent = `Heard: ${letters[this.two.heard]}`;
    };
    this.showComparison();
  }

  showComparison() {
    const [pair] = data.compared;
    if (!pair) return;
    element("distance").textContent =
      `${pair.pairs.length} partials of A have one of B within 100 cents; ${pair.first_alone} have none. ` +
      `Root mean square of their distances: ${fixed(pair.cents, 1)} cents and ${fixed(pair.level, 1)} dB. ` +
      `A-weighted exposure of B relative to A: ${fixed(pair.exposure, 1)} dB.`;
    fill(element("pairs"), ["A / Hz", "B / Hz", "cents", "level / dB", "T60 of B over A"],
         pair.pairs.map(({frequency, other_frequency: other, cents, level, decay_ratio: ratio}) =>
           [fixed(frequency, 2), fixed(other, 2), fixed(cents, 1), fixed(level, 1), fixed(ratio, 2)]));
  }

  connectSpectra() {
    const names = [...new Set(results.flatMap(({channels}) => channels.map(({name}) => name)))];
    for (const name of names) element("channel").append(new Option(name, name));
    element("channel").onchange = () => this.showSound();
    element("range").oninput = () => {
      this.spectra.span = Number(element("range").value);
      element("range-text").textContent = `${this.spectra.span} dB`;
      this.spectra.request();
    };
    element("range-text").textContent = `${this.spectra.span} dB`;
    element("whole").onclick = () => this.spectra.whole();
  }

  /// Shows one of the results.
  choose(index) {
    this.shown = index;
    [...element("results").children].forEach((button, i) => button.setAttribute("aria-pressed", i === index));
    this.showSound();
    this.showFrames();
    this.showChannels();
    this.showRun();
  }

  channelOf(result) {
    return result.channels.find(({name}) => name === element("channel").value) || result.channels[0];
  }

  /// The number of the impact that is loudest in a channel.
  loudestOf({stretches}) {
    return stretches.reduce((best, {peak}, index) => peak > stretches[best].peak ? index : best, 0);
  }

  showSound() {
    const result = results[this.shown], order = isPair ? [this.shown, 1 - this.shown] : [0];
    const shown = order.map(index => {
      const channel = this.channelOf(results[index]);
      return {...channel, partials: channel.stretches[this.loudestOf(channel)].partials, colour: colours[index]};
    });
    this.spectra.show(shown, result.references, result.impacts.map(({time}) => time));
    const references = result.references.map(({name}) => name).join(", ");
    element("legend").textContent = "Green: partials." + (references ? ` Dashed: ${references}.` : "") +
      (isPair ? " Blue: A, orange: B." : "");
    this.showImpacts(result, shown[0]);
    this.chooseImpact(this.loudestOf(shown[0]));
  }

  /// The blows of a result, with what a channel has of each.
  showImpacts({impacts, impacts_left_out: more}, channel) {
    element("impacts-section").hidden = impacts.length + more < 2;
    element("impacts-note").textContent = "Contacts of the run, and beginnings of the sound that none of them explains. " +
      "A click shows the sound and the partials of one." + (more ? ` ${more} quieter ones are left out.` : "");
    const withPressure = channel.unit === "Pa";
    fill(element("impacts"), ["time / s", "contact", "force / N", withPressure ? "peak / Pa" : "peak", "partials", "strongest / Hz"],
         impacts.map(({time, cause, force}, index) => {
           const {peak, duration, partials} = channel.stretches[index];
           const strongest = [...partials].sort((a, b) => b.level - a.level).slice(0, 3);
           return [fixed(time, 3), cause || "–", cause ? force.toPrecision(3) : "–", peak.toPrecision(3),
                   duration ? partials.length : "the next one is too near",
                   strongest.map(({frequency}) => fixed(frequency, 1)).join(", ")];
         }));
    this.impactRows().forEach((row, index) => row.onclick = () => {
      const next = impacts[index + 1]?.time ?? Infinity, {time} = impacts[index];
      this.chooseImpact(index);
      this.spectra.showTime(time - 0.02, Math.min(next, time + 4));
    });
  }

  impactRows() {
    return [...element("impacts").rows].slice(1);
  }

  chooseImpact(index) {
    const result = results[this.shown], channel = this.channelOf(result), stretch = channel.stretches[index];
    this.impactRows().forEach((row, i) => row.setAttribute("aria-selected", i === index));
    this.spectra.channels[0].partials = stretch.partials;
    this.showPartials(channel, stretch, result.impacts[index].time, result.references);
  }

  showPartials({name, unit, attached}, {start, duration, complete, partials}, time, references) {
    element("partials-note").textContent =
      `${name}, impact at ${short(time)} s: ${partials.length} partials from ${short(start)} s to ${short(start + duration)} s; ` +
      `levels re 1 ${unit} at ${short(start)} s.` + (attached ? ` The listener moves with ${attached}.` : "") +
      (complete ? "" : " The search ended early: what is left is no sum of damped sines, but, for example, noise.");
    const withPressure = unit === "Pa";
    const heads = ["frequency / Hz", "level / dB", ...(withPressure ? ["SPL / dB"] : []), "T60 / s",
                   ...references.map(({name: of}) => `cents from ${of}`), ""];
    fill(element("partials"), heads, partials.map(({frequency, level, spl, decay_time: decay, remainder}) =>
      [fixed(frequency, 2), fixed(level, 1), ...(withPressure ? [fixed(spl, 1)] : []), fixed(decay, 3),
       ...references.map(({frequencies}) => fixed(centsFrom(frequency, frequencies), 1)),
       remainder === null ? "" : `not a single one: ${fixed(remainder, 0)} dB remain`]));
  }

  showFrames() {
    const {frames} = results[this.shown];
    element("motion").hidden = !frames;
    cancelAnimationFrame(this.animation);
    this.view = null;
    if (!frames) return;
    const room = element("room").cloneNode();  // a canvas keeps its context
    element("room").replaceWith(room);
    this.view = new FramesView(room, frames);
    this.connectView(room, frames);
    this.setFrame(0);
    const draw = time => {
      if (this.running) this.setFrame(Math.floor((time - this.started) / 33) % frames.times.length);
      this.view.draw(0, -1);
      this.animation = requestAnimationFrame(draw);
    };
    this.animation = requestAnimationFrame(draw);
  }

  connectView(room, frames) {
    let last = null;
    room.onpointerdown = event => {
      room.setPointerCapture(event.pointerId);
      last = event;
    };
    room.onpointermove = event => {
      if (last) this.view.turn(-0.008 * (event.clientX - last.clientX), 0.008 * (event.clientY - last.clientY));
      last = last && event;
    };
    room.onpointerup = room.onpointercancel = () => last = null;
    room.addEventListener("wheel", event => {
      event.preventDefault();
      this.view.zoom(Math.exp(0.001 * event.deltaY));
    }, {passive: false});
    element("frame").max = frames.times.length - 1;
    element("frame").oninput = () => this.setFrame(Number(element("frame").value));
    element("exaggeration").value = Math.log10(this.view.visibleFactor());
    element("exaggeration").oninput = () => this.setFactor();
    element("run").onclick = () => {
      this.running = !this.running;
      this.started = performance.now() - 33 * Number(element("frame").value);
      element("run").textContent = this.running ? "Stop" : "Play";
    };
    this.setFactor();
  }

  setFactor() {
    this.view.factor = 10 ** Number(element("exaggeration").value);
    element("exaggeration-text").textContent = `× ${this.view.factor.toPrecision(2)}`;
  }

  setFrame(number) {
    this.view.showFrame(number);
    element("frame").value = number;
    element("frame-text").textContent = `${this.view.times[number].toFixed(4)} s`;
  }

  showChannels() {
    const {series} = results[this.shown];
    element("channels").hidden = !series.length;
    element("plots").replaceChildren();
    for (const {path, unit, columns, times, values} of series) {
      const title = document.createElement("p"), canvas = document.createElement("canvas");
      const tints = ["#246", "#c60", "#2a7", "#a2a", "#888"];
      title.append(`${path.slice(1)}: `);
      columns.forEach((column, c) => {
        const name = document.createElement("span");
        name.textContent = `${column}  `;
        name.style.color = tints[c % tints.length];
        title.append(name);
      });
      canvas.className = "plot";
      element("plots").append(title, canvas);
      const lowest = values.reduce((least, value) => Math.min(least, value), 0);
      const highest = values.reduce((most, value) => Math.max(most, value), 0);
      const room = 0.05 * (highest - lowest) || 1;
      const plot = new Plot(canvas, {x: new Range(0, times[times.length - 1] || 1), y: new Range(lowest - room, highest + room),
                                     xLabel: "time (s)", yLabel: unit});
      plot.begin();
      plot.axes();
      columns.forEach((_, c) =>
        plot.line(times, times.map((__, row) => values[row * columns.length + c]), tints[c % tints.length]));
    }
  }

  showRun() {
    const {run, file, code_version: version} = results[this.shown], {deck, bodies = {}, ...rest} = run;
    const facts = Object.entries(bodies);
    element("summary").textContent = `${file}, written by version ${version}.`;
    fill(element("accuracy"), ["body", "element", "nodes", "within 5 cents up to", "within 50 cents up to"],
         facts.map(([name, body]) =>
           [name, body.element || "–", short(body.nodes || 0),
            ...["highest_within_5_cents", "highest_within_50_cents"].map(key => key in body ? `${fixed(body[key], 0)} Hz` : "not known")]));
    fill(element("facts"), ["", ""], flat({...rest, bodies}));
    element("deck").textContent = deck || "";
  }
}

try {
  window.idiophone = {report: new Report(), results};
} catch (error) {
  element("problem").textContent = error.message;
  throw error;
}
