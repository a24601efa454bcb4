// The bodies of a run, frame by frame.

/// @param body  as the program writes it (src/study/report/page_motion.cpp)
function readFramedBody(body) {
  return {...body, vertices: decoded(body.vertices, Float32Array), triangles: decoded(body.triangles, Uint32Array),
          displacement: decoded(body.displacement, Int16Array)};
}

class FramesView extends View {
  constructor(canvas, frames) {
    super(canvas, frames.bodies.map(readFramedBody));
    this.times = frames.times;
    this.factor = 1;
  }

  /// By how much displacements must be enlarged to be seen: the largest becomes a twentieth of its body's size.
  visibleFactor() {
    let factor = 1e6;
    this.bodies.forEach(({displacement, scale}, index) => {
      const largest = scale * displacement.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
      if (largest > 0) factor = Math.min(factor, 0.05 * this.bodySize(index) / largest);
    });
    return factor < 1e6 ? Math.max(1, factor) : 1;
  }

  showFrame(number) {
    this.bodies.forEach(({displacement, scale, vertices}, index) => {
      const from = number * vertices.length;
      this.setShape(index, Float32Array.from(displacement.subarray(from, from + vertices.length), value => value * scale));
    });
  }

  swingOf() {
    return this.factor;
  }
}
