// The pointer as a tool that scrapes or a ball that rolls over a body. Mass and hardness are those of the hammer.

const contactSize = {scrape: 1e-4, roll: 2e-4};  // m
const roughness = {exponent: 1, longest: 5e-3, shortest: 2e-5};
const profiles = {};  // of the surface, by what the pointer does

class Scraping {
  constructor(explorer) {
    this.explorer = explorer;
    this.strokes = new Map();  // by pointer: body, place and time of the last news
    for (const id of ["load", "roughness", "grip"]) element(id).oninput = () => this.showNumbers();
    element("pointer").onchange = () => this.showNumbers();
    this.showNumbers();
  }

  get kind() {
    return element("pointer").value;
  }

  showNumbers() {
    const read = id => 10 ** Number(element(id).value);
    this.load = read("load");
    this.height = read("roughness");
    this.grip = Number(element("grip").value);
    element("stroke").hidden = this.kind === "strike";
    element("grip").parentElement.hidden = this.kind !== "scrape";
    element("load-text").textContent = `${this.load.toPrecision(2)} N`;
    element("roughness-text").textContent = `${(1e6 * this.height).toPrecision(2)} µm`;
    element("grip-text").textContent = this.grip.toFixed(2);
  }

  /// Whether the pointer touches a body with a tool.
  begin(event, [x, y]) {
    const seen = this.kind === "strike" ? null : pick(this.explorer.view, x, y);
    if (!seen) return false;
    this.strokes.set(event.pointerId, {kind: this.kind, body: seen.body, place: seen.point.place, time: event.timeStamp});
    this.start(event, seen);
    return true;
  }

  async start({pointerId, pointerType, pressure}, {body, point}) {
    const {explorer, kind} = this, {mass, hardness} = explorer.hammer();
    explorer.choose(body);
    profiles[kind] ??= profileOf(roughness, contactSize[kind]);
    const tool = {mass, hardness, height: this.height, profile: profiles[kind]};
    const news = {load: this.loadOf(pointerType, pressure), speed: 0, shares: this.sharesAt(body, point, [0, 0, 0])};
    await explorer.sound.start();
    if (!this.strokes.has(pointerId)) return;  // lifted off before the sound began
    explorer.sound.send({stroke: {id: pointerId, body, level: bodies[body].level, tool, news}});
  }

  move({pointerId, pointerType, pressure, timeStamp}, [x, y]) {
    const stroke = this.strokes.get(pointerId), seen = pick(this.explorer.view, x, y);
    if (!stroke || seen?.body !== stroke.body || timeStamp <= stroke.time) return;
    const way = minus(seen.point.place, stroke.place), length = Math.hypot(...way), speed = 1000 * length / (timeStamp - stroke.time);
    const drag = stroke.kind === "scrape" && length > 0 ? scaled(way, this.grip / length) : [0, 0, 0];
    Object.assign(stroke, {place: seen.point.place, time: timeStamp});
    const news = {load: this.loadOf(pointerType, pressure), speed, shares: this.sharesAt(stroke.body, seen.point, drag)};
    this.explorer.sound.send({follow: {id: pointerId, news}});
    element("blow").textContent = `${bodies[stroke.body].name}: ${speed.toPrecision(2)} m/s, ${news.load.toPrecision(2)} N`;
  }

  end({pointerId}) {
    if (this.strokes.delete(pointerId)) this.explorer.sound.send({lift: pointerId});
  }

  /// N: a pen or a finger presses by its own pressure, half of which is the slider's load; a mouse has none.
  loadOf(pointerType, pressure) {
    return pointerType === "mouse" || !pressure ? this.load : 2 * pressure * this.load;
  }

  /// Shares of the modes or masses in a force of 1 N inwards, and of friction along the way.
  sharesAt(index, point, drag) {
    const body = bodies[index], direction = drag.map((part, axis) => part - point.normal[axis]);
    return body.level === null ? {participation: participationOf(body, point, direction)}
                               : {loads: loadsOn(body.proxies[body.level], point.place, direction)};
  }
}
