// The page of the tuning bench. Runs after bands.js.

const element = id => document.getElementById(id);
const signed = (value, digits = 1) => (value < 0 ? "−" : "+") + Math.abs(value).toFixed(digits);
const millimetres = (metres, digits = 1) => (1000 * metres).toFixed(digits).replace("-", "−");

function fill(table, heads, rows) {
  const row = (kind, cells) => {
    const line = document.createElement("tr");
    for (const text of cells) line.appendChild(document.createElement(kind)).textContent = text;
    return line;
  };
  table.replaceChildren(row("th", heads), ...rows.map(cells => row("td", cells)));
}

class Bench {
  constructor(data) {
    this.facts = data.facts;
    this.surface = {vertices: decoded(data.vertices, Float32Array), triangles: decoded(data.triangles, Uint32Array)};
    this.slopes = data.slopes.map(text => decoded(text, Float32Array));  // [partials][vertices]
    this.showFacts();
    this.view = new BandedView(element("room"), this.surface, this.facts.side === "-z");
    turnByPointer(element("room"), this.view);
    turnByKeys(element("room"), this.view);
    this.makeChoice();
    this.choose(0);
    const draw = time => {
      this.view.animate(time, -1);
      requestAnimationFrame(draw);
    };
    requestAnimationFrame(draw);
  }

  showFacts() {
    const {body, advice, side, along, partials, cuts} = this.facts, modes = partials.map(({mode}) => `mode ${mode}/ct`);
    element("body").textContent = body;
    element("advice").textContent = `${advice[0].toUpperCase()}${advice.slice(1)}.`;
    fill(element("partials"), ["mode", "computed/Hz", "measured/Hz", "wanted/Hz", "missing/ct", "after the cuts/ct"],
         partials.map(({mode, computed, measured, wanted, missing, expected, uncertainty}) =>
           [mode, computed.toFixed(2), measured === null ? "–" : measured.toFixed(2), wanted.toFixed(2), signed(missing),
            `${signed(expected)} ± ${uncertainty.toFixed(1)}`]));
    element("carried").textContent = partials.filter(({carried_over}) => carried_over).map(({mode, carried_over}) =>
      `The last tap has no line of mode ${mode}. The line is that of tap ${carried_over.tap}, moved by ` +
      `${signed(carried_over.moved)} ct by the cuts since then, ± ${carried_over.uncertainty.toFixed(1)}.`).join(" ");
    element("where").textContent = cuts.length > 0 ? `At the side ${side}, across the whole side.` : "None.";
    fill(element("cuts"), cuts.length > 0 ? ["tool", `${along}/mm`, "width/mm", "depth/mm", ...modes] : [],
         cuts.map(({tool, place, width, depth, cents}) =>
           [tool, millimetres(place), millimetres(width), millimetres(depth, 2), ...cents.map(value => signed(value))]));
  }

  makeChoice() {
    this.facts.partials.forEach(({mode}, partial) => {
      const button = element("choice").appendChild(document.createElement("button"));
      button.textContent = `Mode ${mode}`;
      button.onclick = () => this.choose(partial);
    });
  }

  /// Colours the surface by what removed material does to a partial.
  choose(partial) {
    [...element("choice").children].forEach((button, number) => button.setAttribute("aria-pressed", number === partial));
    const slopes = this.slopes[partial], {triangles} = this.surface;
    const largest = slopes.reduce((most, value) => Number.isFinite(value) ? Math.max(most, Math.abs(value)) : most, 0);
    const bands = [];
    for (let i = 0; i < triangles.length; i += 3) {
      const mean = (slopes[triangles[i]] + slopes[triangles[i + 1]] + slopes[triangles[i + 2]]) / 3;
      bands.push(this.isCut(i) ? cutBand : bandOf(mean, largest));
    }
    this.view.colour(bands);
    element("legend").replaceChildren(...bandColours.slice(0, slopeBands).map((colour, band) => {
      const field = document.createElement("span");
      field.style.background = `rgb(${colour.map(part => Math.round(255 * part))})`;
      field.style.color = band < 2 || band > 6 ? "#fff" : "#111";
      field.textContent = signed(largest * ((2 * band + 1) / slopeBands - 1), 2);
      return field;
    }));
  }

  /// Whether a triangle lies in one of the next cuts.
  isCut(first) {
    const {vertices, triangles} = this.surface, {side, along, cuts} = this.facts;
    const corners = [0, 1, 2].map(k => vertices.subarray(3 * triangles[first + k], 3 * triangles[first + k] + 3));
    const normal = unit(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0])));
    const facing = normal["xyz".indexOf(side[1])] * (side[0] === "+" ? 1 : -1);
    const axis = "xyz".indexOf(along), middle = (corners[0][axis] + corners[1][axis] + corners[2][axis]) / 3;
    return facing > 0.5 && cuts.some(({place, width}) => Math.abs(middle - place) < width / 2);
  }
}

try {
  window.idiophone = {bench: new Bench(JSON.parse(element("data").textContent))};
} catch (error) {
  element("problem").textContent = error.message;
  throw error;
}
