// A canvas on which the pointer draws an outline.

class Drawing {
  /// @param done  is called with the points of a line that has been drawn, [[x, y], ...]; y upwards
  constructor(canvas, done) {
    this.canvas = canvas;
    canvas.onpointerdown = event => {
      canvas.setPointerCapture(event.pointerId);
      this.line = [this.pointOf(event)];
    };
    canvas.onpointermove = event => {
      if (!this.line) return;
      this.line.push(...(event.getCoalescedEvents?.() ?? [event]).map(each => this.pointOf(each)));
      this.draw(this.line, false);
    };
    canvas.onpointercancel = () => this.line = null;
    canvas.onpointerup = () => {
      const line = this.line;
      this.line = null;
      if (line) done(line);
    };
  }

  /// Place of the pointer; the canvas is 1 high.
  pointOf({clientX, clientY}) {
    const {left, bottom, height} = this.canvas.getBoundingClientRect();
    return [(clientX - left) / height, (bottom - clientY) / height];
  }

  /// An outline about the origin with an extent of 1.
  show(outline) {
    const middle = this.canvas.width / this.canvas.height / 2;
    this.draw(outline.map(([x, y]) => [middle + 0.9 * x, 0.5 + 0.9 * y]), true);
  }

  draw(points, closed) {
    const {canvas} = this, {width, height} = canvas, pen = canvas.getContext("2d");
    pen.clearRect(0, 0, width, height);
    pen.strokeStyle = "#246";
    pen.beginPath();
    for (const [x, y] of points) pen.lineTo(height * x, height * (1 - y));
    if (closed) pen.closePath();
    pen.stroke();
  }
}
