// The page: fills it with the results, and connects what a user can change.

const data = JSON.parse(document.getElementById("data").textContent);
const element = id => document.getElementById(id);
const letters = ["A", "B"];

const results = data.results.map(result => ({
  ...result,
  channels: result.channels.map(readChannel),
  series: result.series.map(series => ({...series, times: decoded(series.times, Float32Array),
                                        values: decoded(series.values, Float32Array)})),
}));
const isPair = results.length === 2;
const labelOf = index => isPair ? `${letters[index]}: ${results[index].name}` : results[index].name;

/// Shows an impact; its row is clicked, too.
function impactButton(time) {
  const button = document.createElement("button");
  button.textContent = fixed(time, 3);
  button.setAttribute("aria-label", `Impact at ${fixed(time, 3)} seconds`);
  return button;
}

class Report {
  constructor() {
    this.spectra = new Spectra(element("spectrogram"), element("spectrum"));
    this.shown = 0;
    document.title = `Idiophone: ${results.map(({name}) => name).join(" and ")}`;
    element("title").textContent = results.map((_, index) => labelOf(index)).join("   ");
    this.motion = new Motion();
    this.series = new SeriesPlots();
    darkScheme.addEventListener("change", () => this.series.draw());
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
    if (!pair) {
      element("distance").textContent = "The sounds have different units, so their levels and partials are not compared.";
      return;
    }
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
    element("closer").onclick = () => this.spectra.above.zoom(0.6);
    element("farther").onclick = () => this.spectra.above.zoom(1 / 0.6);
    element("all-impacts").onclick = () => this.chooseAll();
  }

  /// Shows one of the results.
  choose(index) {
    this.shown = index;
    [...element("results").children].forEach((button, i) => button.setAttribute("aria-pressed", i === index));
    this.showSound();
    showModes(results[index].modes);
    this.motion.show(results[index].frames);
    this.series.show(results[index].series);
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
      return {...channel, partials: channel.stretches[this.loudestOf(channel)].partials, line: lineColour(index)};
    });
    this.spectra.show(shown, result.references, result.impacts.map(({time}) => time));
    const references = result.references.map(({name}) => name).join(", ");
    element("legend").textContent =
      `Colours: energy of a pixel, re a sine of amplitude 1 ${shown[0].unit}. Green: partials.` + (references ? ` Dashed: ${references}.` : "") +
      (isPair ? " Blue: A, orange: B." : "");
    this.showImpacts(result, shown[0]);
    if (result.impacts.length > 1) {
      this.chooseAll();
    } else {
      this.chooseImpact(0);
    }
  }

  /// The blows of a result, with what a channel has of each.
  showImpacts({impacts, impacts_left_out: more}, channel) {
    element("impacts-section").hidden = impacts.length + more < 2;
    element("impacts-note").textContent = "Contacts of the run, and beginnings of the sound that none of them explains. " +
      "A click on a time shows the sound and the partials of one." + (more ? ` ${more} quieter ones are left out.` : "");
    const withPressure = channel.unit === "Pa";
    fill(element("impacts"), ["time / s", "contact", "force / N", withPressure ? "peak / Pa" : "peak", "partials", "strongest / Hz"],
         impacts.map(({time, cause, force}, index) => {
           const {peak, duration, partials} = channel.stretches[index];
           const strongest = [...partials].sort((a, b) => b.level - a.level).slice(0, 3);
           return [impactButton(time), cause || "–", cause ? force.toPrecision(3) : "–", peak.toPrecision(3),
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
    return [...element("impacts").tBodies[0].rows];
  }

  /// Marks the row of an impact, or none.
  mark(chosen) {
    this.impactRows().forEach((row, index) => {
      row.classList.toggle("chosen", index === chosen);
      row.querySelector("button").setAttribute("aria-pressed", index === chosen);
    });
    element("all-impacts").hidden = results[this.shown].impacts.length < 2;
    element("all-impacts").setAttribute("aria-pressed", chosen === null);
  }

  chooseImpact(index) {
    const result = results[this.shown], channel = this.channelOf(result), stretch = channel.stretches[index];
    const {start, duration, complete, partials} = stretch;
    this.mark(index);
    this.showPartials(channel, partials, result.references,
      `impact at ${short(result.impacts[index].time)} s: ${partials.length} partials from ${short(start)} s to ` +
      `${short(start + duration)} s; levels re 1 ${channel.unit} at ${short(start)} s.` +
      (complete ? "" : " The search ended early: what is left is no sum of damped sines, but, for example, noise."));
  }

  /// The partials of all impacts, those that can't be told apart as one.
  chooseAll() {
    const result = results[this.shown], channel = this.channelOf(result);
    const analysed = channel.stretches.filter(({duration}) => duration > 0).length;
    this.mark(null);
    this.showPartials(channel, channel.recurring, result.references,
      `${channel.recurring.length} partials of ${analysed} impacts. Level (re 1 ${channel.unit}) and T60 are those after ` +
      "the impact that excites the partial most.", true);
  }

  /// @param recur  whether they have the number of their impacts
  showPartials({name, unit, attached}, partials, references, note, recur = false) {
    this.spectra.channels[0].partials = partials;
    this.spectra.request();
    element("partials-note").textContent = `${name}, ${note}` + (attached ? ` The listener moves with ${attached}.` : "");
    const withPressure = unit === "Pa";
    const heads = ["frequency / Hz", "level / dB", ...(withPressure ? ["SPL / dB"] : []), "T60 / s", ...(recur ? ["impacts"] : []),
                   ...references.map(({name: of}) => `cents from ${of}`), ""];
    fill(element("partials"), heads, partials.map(({frequency, level, spl, decay_time: decay, impacts, remainder}) =>
      [fixed(frequency, 2), fixed(level, 1), ...(withPressure ? [fixed(spl, 1)] : []), fixed(decay, 3), ...(recur ? [impacts] : []),
       ...references.map(set => nearestOf(frequency, set)),
       remainder === null ? "" : `not a single one: ${fixed(remainder, 0)} dB remain`]));
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
