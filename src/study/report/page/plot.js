"use strict";
// A canvas with axes, whose ranges are zoomed by the wheel and moved by dragging.

/// A colour of the page's scheme, light or dark.
const theme = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/// The colour of line number `index` of a plot.
const lineColour = index => `--line-${index % 5}`;

/// Round numbers between two limits.
function ticks(low, high, most) {
  const rough = (high - low) / most, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(factor => factor * power).find(size => size >= rough);
  const all = [];
  for (let value = Math.ceil(low / step) * step; value <= high + 1e-9 * step; value += step) all.push(value);
  return all;
}

/// A short number: no zeros after the last digit that differs.
function short(value) {
  return String(Number(value.toPrecision(6)));
}

/// An interval [low, high] of an axis within its bounds.
class Range {
  constructor(low, high) {
    this.bounds = [low, high];
    this.reset();
  }
  reset() {
    [this.low, this.high] = this.bounds;
  }
  /// Keeps the value at `part` (0 to 1) of the interval where it is.
  zoom(part, factor) {
    const middle = this.low + part * (this.high - this.low), [least, most] = this.bounds;
    const size = Math.min(most - least, Math.max(1e-4 * (most - least), factor * (this.high - this.low)));
    this.low = Math.min(Math.max(least, middle - part * size), most - size);
    this.high = this.low + size;
  }
  /// By a part of the interval.
  move(part) {
    const size = this.high - this.low, [least, most] = this.bounds;
    this.low = Math.min(Math.max(least, this.low + part * size), most - size);
    this.high = this.low + size;
  }
  toPart(value) {
    return (value - this.low) / (this.high - this.low);
  }
}

class Plot {
  /// @param x, y     ranges; a user changes those with `zoomable`
  /// @param right    margin, pixels
  /// @param changed  is called after that
  constructor(canvas, {x, y, xLabel, yLabel, zoomable = [], right = 12, changed = () => {}}) {
    Object.assign(this, {canvas, x, y, xLabel, yLabel, zoomable, changed});
    this.pen = canvas.getContext("2d");
    this.margin = {left: 62, right, top: 8, bottom: 36};
    if (zoomable.length) {
      this.listen();
      this.listenToKeys();
    }
  }

  /// Makes the canvas as fine as the screen, and clears it.
  begin() {
    const {canvas, pen} = this, ratio = window.devicePixelRatio || 1;
    canvas.width = Math.round(canvas.clientWidth * ratio);
    canvas.height = Math.round(canvas.clientHeight * ratio);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.width = canvas.clientWidth - this.margin.left - this.margin.right;
    this.height = canvas.clientHeight - this.margin.top - this.margin.bottom;
    pen.fillStyle = theme("--card");
    pen.fillRect(0, 0, canvas.clientWidth, canvas.clientHeight);
  }

  left(value) {
    return this.margin.left + this.width * this.x.toPart(value);
  }
  top(value) {
    return this.margin.top + this.height * (1 - this.y.toPart(value));
  }

  /// Calls draw, whose strokes stay within the axes.
  within(draw) {
    const {pen, margin} = this;
    pen.save();
    pen.beginPath();
    pen.rect(margin.left, margin.top, this.width, this.height);
    pen.clip();
    draw(pen);
    pen.restore();
  }

  line(xs, ys, colour) {
    this.within(pen => {
      pen.strokeStyle = colour;
      pen.beginPath();
      for (let i = 0; i < xs.length; ++i) pen.lineTo(this.left(xs[i]), this.top(ys[i]));
      pen.stroke();
    });
  }

  axes() {
    const {pen, margin} = this, bottom = margin.top + this.height;
    pen.font = "12px system-ui, sans-serif";
    pen.strokeStyle = "rgba(120, 120, 120, 0.25)";
    pen.fillStyle = theme("--quiet");
    pen.textAlign = "center";
    for (const value of ticks(this.x.low, this.x.high, this.width / 90)) {
      pen.strokeRect(this.left(value), margin.top, 0, this.height);
      pen.fillText(short(value), this.left(value), bottom + 15);
    }
    pen.fillText(this.xLabel, margin.left + this.width / 2, bottom + 31);
    pen.textAlign = "right";
    for (const value of ticks(this.y.low, this.y.high, this.height / 40)) {
      pen.strokeRect(margin.left, this.top(value), this.width, 0);
      pen.fillText(short(value), margin.left - 5, this.top(value) + 4);
    }
    pen.save();
    pen.translate(13, margin.top + this.height / 2);
    pen.rotate(-Math.PI / 2);
    pen.textAlign = "center";
    pen.fillText(this.yLabel, 0, 0);
    pen.restore();
    pen.strokeStyle = theme("--quiet");
    pen.strokeRect(margin.left, margin.top, this.width, this.height);
  }

  /// The ranges that a user changes, by their names.
  ranges() {
    return this.zoomable.map(name => [name, this[name]]);
  }

  zoom(factor) {
    for (const [, range] of this.ranges()) range.zoom(0.5, factor);
    this.changed();
  }

  reset() {
    for (const [, range] of this.ranges()) range.reset();
    this.changed();
  }

  listenToKeys() {
    const move = (name, part) => {
      if (this.zoomable.includes(name)) this[name].move(part);
      this.changed();
    };
    const actions = {
      ArrowLeft: () => move("x", -0.1), ArrowRight: () => move("x", 0.1), ArrowUp: () => move("y", 0.1),
      ArrowDown: () => move("y", -0.1), "+": () => this.zoom(0.7), "-": () => this.zoom(1 / 0.7), 0: () => this.reset(),
    };
    this.canvas.addEventListener("keydown", event => {
      const scrolls = event.key === "ArrowUp" || event.key === "ArrowDown";
      if (!actions[event.key] || event.ctrlKey || event.altKey || event.metaKey) return;
      if (scrolls && !this.zoomable.includes("y")) return;
      event.preventDefault();
      actions[event.key]();
    });
  }

  listen() {
    const {canvas} = this, axes = () => this.ranges();
    const part = (name, event) => name === "x" ? (event.offsetX - this.margin.left) / this.width
                                               : 1 - (event.offsetY - this.margin.top) / this.height;
    canvas.addEventListener("wheel", event => {
      event.preventDefault();
      for (const [name, range] of axes()) range.zoom(Math.min(1, Math.max(0, part(name, event))), Math.exp(0.002 * event.deltaY));
      this.changed();
    }, {passive: false});
    let last = null;
    canvas.onpointerdown = event => {
      canvas.setPointerCapture(event.pointerId);
      last = event;
    };
    canvas.onpointermove = event => {
      if (!last) return;
      for (const [name, range] of axes()) {
        const scrolls = name === "y" && event.pointerType === "touch";  // the page
        if (!scrolls) range.move(part(name, last) - part(name, event));
      }
      last = event;
      this.changed();
    };
    canvas.onpointerup = canvas.onpointercancel = () => last = null;
    canvas.ondblclick = () => this.reset();
  }
}
