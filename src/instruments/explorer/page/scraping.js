// The pointer as a tool that scrapes, a ball that rolls, or a bow that rubs a body. Mass and hardness are those of the hammer.

const contactSize = {scrape: 1e-4, roll: 2e-4};  // m
const roughness = {exponent: 1, longest: 5e-3, shortest: 2e-5};
const profiles = {};  // of the surface, by what the pointer does

class Scraping {
  constructor(explorer) {
    this.explorer = explorer;
    this.strokes = new Map();  // by pointer: body, place and time of the last news
    for (const id of ["load", "roughness", "grip"]) element(id).oninput = () => this.showNumbers();
    element("pointer").onchange = () => this.showNumbers();
    if (!compiledBytes) element("pointer").querySelector("[value=bow]").remove();
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
    element("roughness").parentElement.hidden = this.kind === "bow";
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
    const {explorer, kind} = this, {level} = bodies[body];
    explorer.choose(body);
    if (kind === "bow" && level !== null) return tell("Only modes can be bowed: choose them under What sounds.");
    const news = {load: this.loadOf(pointerType, pressure), speed: 0, shares: this.sharesAt(kind, body, point)};
    await explorer.sound.start();
    if (!this.strokes.has(pointerId)) return;  // lifted off before the sound began
    explorer.sound.send({stroke: {id: pointerId, kind, body, level, tool: kind === "bow" ? null : this.tool(kind), news}});
  }

  tool(kind) {
    const {mass, hardness} = this.explorer.hammer();
    profiles[kind] ??= profileOf(roughness, contactSize[kind]);
    return {mass, hardness, height: this.height, profile: profiles[kind]};
  }

  move({pointerId, pointerType, pressure, timeStamp}, [x, y]) {
    const stroke = this.strokes.get(pointerId), seen = pick(this.explorer.view, x, y);
    if (!stroke || seen?.body !== stroke.body || timeStamp <= stroke.time) return;
    const way = minus(seen.point.place, stroke.place), length = Math.hypot(...way), speed = 1000 * length / (timeStamp - stroke.time);
    Object.assign(stroke, {place: seen.point.place, time: timeStamp});
    const news = {load: this.loadOf(pointerType, pressure), speed, shares: this.sharesAt(stroke.kind, stroke.body, seen.point, way)};
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

  /// Shares of the modes or masses in a force of 1 N: on a tool inwards, and of friction along the way; of a bow, which goes at right
  /// angles to the surface as over its edge.
  sharesAt(kind, index, point, way = [0, 0, 0]) {
    const body = bodies[index], length = Math.hypot(...way);
    const drag = kind === "scrape" && length > 0 ? scaled(way, this.grip / length) : [0, 0, 0];
    const direction = kind === "bow" ? point.normal : minus(drag, point.normal);
    return kind === "bow" ? {participation: participationOf(body, point, direction)} : sharesOf(body, point, direction);
  }
}
