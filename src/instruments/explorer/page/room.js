// The pointer and the keys in the room: they turn it, zoom, strike, scrape and roll.

class Room {
  /// @param strike  is called with a place of the canvas, CSS pixels
  /// @param tool    scrapes and rolls (scraping.js): begin(event, place) says whether it takes a pointer
  constructor(canvas, view, strike, tool) {
    Object.assign(this, {canvas, view, strike, tool});
    this.drawn = new Set();   // pointers that the tool has taken
    this.touches = new Map();
    this.moved = 0;   // CSS pixels since the pointer went down
    this.spread = 0;  // likewise, between two fingers
    canvas.onpointerdown = event => this.press(event);
    canvas.onpointermove = event => this.move(event);
    canvas.onpointerup = canvas.onpointercancel = event => this.release(event);
    canvas.onkeydown = event => this.onKey(event);
    canvas.addEventListener("wheel", event => {
      event.preventDefault();
      view.zoom(Math.exp(0.001 * event.deltaY));
    }, {passive: false});
  }

  placeOf({clientX, clientY}) {
    const {left, top} = this.canvas.getBoundingClientRect();
    return [clientX - left, clientY - top];
  }

  press(event) {
    this.canvas.setPointerCapture(event.pointerId);
    if (this.tool.begin(event, this.placeOf(event))) {
      this.drawn.add(event.pointerId);
      return;
    }
    this.touches.set(event.pointerId, event);
    this.moved = this.touches.size > 1 ? Infinity : 0;
    this.spread = 0;
  }

  move(event) {
    if (this.drawn.has(event.pointerId)) {
      this.tool.move(event, this.placeOf(event));
      return;
    }
    const before = this.touches.get(event.pointerId);
    if (!before) return;
    this.touches.set(event.pointerId, event);
    if (this.touches.size === 2) {
      this.pinch();
      return;
    }
    const [right, down] = [event.clientX - before.clientX, event.clientY - before.clientY];
    this.moved += Math.hypot(right, down);
    if (this.moved > 6) this.view.turn(-0.008 * right, 0.008 * down);
  }

  pinch() {
    const [a, b] = [...this.touches.values()], apart = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
    if (this.spread) this.view.zoom(this.spread / apart);
    this.spread = apart;
  }

  release(event) {
    if (this.drawn.delete(event.pointerId)) this.tool.end(event);
    const struck = this.touches.delete(event.pointerId) && event.type === "pointerup" && this.moved <= 6;
    if (struck) this.strike(...this.placeOf(event));
  }

  onKey(event) {
    const {view, canvas: {clientWidth, clientHeight}} = this, strike = () => this.strike(clientWidth / 2, clientHeight / 2);
    const actions = {
      ArrowLeft: () => view.turn(-0.08, 0), ArrowRight: () => view.turn(0.08, 0),
      ArrowUp: () => view.turn(0, 0.08), ArrowDown: () => view.turn(0, -0.08),
      "+": () => view.zoom(0.9), "-": () => view.zoom(1 / 0.9), Home: () => view.goHome(), Enter: strike, " ": strike,
    };
    if (actions[event.key]) {
      event.preventDefault();
      actions[event.key]();
    }
  }
}
