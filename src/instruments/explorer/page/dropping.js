// The part of the page that lets bodies fall.

const dropLatency = 0.06;     // s, by which sound follows the motion: longer than a picture
const mostDropSteps = 10;     // for a picture: a machine that is too slow shows slow motion

class Dropping {
  constructor(explorer) {
    this.explorer = explorer;
    element("drop").hidden = !compiledBytes;
    element("drop-start").onclick = () => this.start();
    element("drop-back").onclick = () => this.putBack();
    for (const id of ["height", "bounce"]) element(`drop-${id}`).oninput = () => this.showNumbers();
    this.showNumbers();
  }

  showNumbers() {
    this.height = 10 ** Number(element("drop-height").value);
    this.bounce = Number(element("drop-bounce").value);
    element("drop-height-text").textContent = `${this.height.toPrecision(2)} m`;
    element("drop-bounce-text").textContent = this.bounce.toFixed(2);
  }

  async start() {
    element("error").hidden = true;
    const context = await this.explorer.sound.start();
    this.code ??= await loadedCode(compiledBytes);
    this.end();
    const {view, chosen} = this.explorer, ways = {chosen: rigid => lift([rigid[chosen]], this.height), all: rigid => lift(rigid, this.height),
                                                  heap: rigid => heap(rigid, view.groundHeight() + this.height)};
    this.drop = new Drop(this.code, view.poses, ways[element("drop-what").value], view.groundHeight(), this.bounce, context.sampleRate);
    this.context = context;
    this.begin = context.currentTime;
  }

  /// To be called for each picture.
  advance() {
    if (!this.drop) return;
    try {
      this.move();
    } catch (error) {
      this.drop = this.code = null;  // what failed may be the C++: the next drop loads it again
      tell(`The drop has ended: ${error.message}`);
    }
  }

  /// By the steps since the last picture.
  move() {
    const {drop, context: {currentTime}, explorer: {view, sound}} = this, strikes = [];
    const steps = Math.floor((currentTime - this.begin) / dropStep) - drop.steps, late = Math.max(0, steps - mostDropSteps);
    this.begin += late * dropStep;
    const first = Math.round((this.begin + dropLatency) * drop.rate);
    for (let n = late; n < steps && !drop.isOver; ++n) strikes.push(...drop.step().map(strike => ({...strike, start: strike.start + first})));
    if (strikes.length) sound.send({strikes});
    view.poses = drop.poses();
    view.changed = true;
    if (drop.isOver) this.end();
  }

  /// The bodies stay where they are.
  end() {
    this.drop?.sounds.end();
    this.drop = null;
  }

  putBack() {
    this.end();
    this.explorer.view.poses = [];
    this.explorer.view.changed = true;
  }
}
