// Energies and contact forces over time.

class SeriesPlots {
  constructor() {
    this.draws = [];
    window.addEventListener("resize", () => this.draw());
  }

  /// @param series  decoded, as the program writes them (src/study/report/page_motion.cpp)
  show(series) {
    element("channels").hidden = !series.length;
    element("plots").replaceChildren();
    this.draws = series.map(each => this.add(each));
    this.draw();
  }

  draw() {
    for (const draw of this.draws) draw();
  }

  /// Adds one canvas with its title. @return  what draws it
  add({path, unit, columns, times, values}) {
    const title = document.createElement("p"), canvas = document.createElement("canvas");
    title.append(`${path.slice(1)}: `);
    columns.forEach((column, c) => {
      const name = document.createElement("span");
      name.textContent = `${column}  `;
      name.style.color = `var(${lineColour(c)})`;
      title.append(name);
    });
    canvas.className = "plot";
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `${path.slice(1)} over time`);
    element("plots").append(title, canvas);
    const lowest = values.reduce((least, value) => Math.min(least, value), 0);
    const highest = values.reduce((most, value) => Math.max(most, value), 0);
    const room = 0.05 * (highest - lowest) || 1;
    const plot = new Plot(canvas, {x: new Range(0, times[times.length - 1] || 1), y: new Range(lowest - room, highest + room),
                                   xLabel: "time (s)", yLabel: unit});
    return () => {
      plot.begin();
      plot.axes();
      columns.forEach((_, c) =>
        plot.line(times, times.map((__, row) => values[row * columns.length + c]), theme(lineColour(c))));
    };
  }
}
