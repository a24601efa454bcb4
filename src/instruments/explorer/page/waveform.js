// The sound of the last two seconds, as the bar at the top of O'Morain's window has it (2005, section 8.4).

class Waveform {
  constructor(canvas) {
    this.canvas = canvas;
    this.pen = canvas.getContext("2d", {willReadFrequently: true});  // drawn without the graphics card: it is small
    this.ranges = [];  // least and greatest sample of one piece after the other
    this.drawn = 0;    // ms
  }

  /// @param ranges  least and greatest sample of each piece of 512 samples
  /// @param rate    samples per second
  add(ranges, rate) {
    this.ranges.push(...ranges);
    this.whole = 2 * Math.round(2 * rate / 512);  // numbers in two seconds
    this.ranges.splice(0, Math.max(0, this.ranges.length - this.whole));
    this.changed = true;
  }

  /// At most ten times a second. @param time  ms
  show(time) {
    if (!this.changed || time - this.drawn < 100) return;
    this.changed = false;
    this.drawn = time;
    this.draw();
  }

  /// What is above zero is green, what is below is red. The loudest sample fills the height.
  draw() {
    const {canvas: {width, height}, pen, ranges, whole} = this;
    const loudest = ranges.reduce((most, value) => Math.max(most, Math.abs(value)), 1e-12), middle = height / 2;
    pen.clearRect(0, 0, width, height);
    pen.fillStyle = "#ccc";
    pen.fillRect(0, middle - 0.5, width, 1);
    ["#b33", "#1a7f37"].forEach((colour, end) => {
      pen.fillStyle = colour;
      pen.beginPath();
      for (let i = 0; i < ranges.length; i += 2) {
        pen.rect(width * (1 - (ranges.length - i) / whole), middle, 2 * width / whole, -middle * ranges[i + end] / loudest);
      }
      pen.fill();
    });
  }
}
