// The section with the bodies in motion, and what a user changes there.

class Motion {
  /// @param frames  of a result; null if it has none
  show(frames) {
    element("motion").hidden = !frames;
    cancelAnimationFrame(this.animation);
    this.view = null;
    if (!frames) return;
    const room = element("room").cloneNode();  // a canvas keeps its context
    element("room").replaceWith(room);
    this.view = new FramesView(room, frames);
    turnByPointer(room, this.view);
    turnByKeys(room, this.view);
    this.connectControls(frames);
    this.setFactor();
    this.setFrame(0);
    const draw = time => {
      if (this.running) this.setFrame(Math.floor((time - this.started) / 33) % frames.times.length);
      this.view.draw(0, -1);
      this.animation = requestAnimationFrame(draw);
    };
    this.animation = requestAnimationFrame(draw);
  }

  connectControls({times}) {
    element("frame").max = times.length - 1;
    element("frame").oninput = () => this.setFrame(Number(element("frame").value));
    element("exaggeration").value = Math.log10(this.view.visibleFactor());
    element("exaggeration").oninput = () => this.setFactor();
    element("run").onclick = () => {
      this.running = !this.running;
      this.started = performance.now() - 33 * Number(element("frame").value);
      element("run").textContent = this.running ? "Stop" : "Play";
    };
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
}
