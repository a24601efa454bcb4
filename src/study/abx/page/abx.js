// The test: trials, answers and the result.

const element = id => document.getElementById(id);
const page = JSON.parse(element("data").textContent);

/// 0 or 1 by chance.
const coin = () => crypto.getRandomValues(new Uint8Array(1))[0] & 1;

class Abx {
  constructor() {
    this.player = new Player(page.sounds);
    element("names").textContent = `A: ${page.names[0]}. B: ${page.names[1]}. ` +
      (page.matched ? "Their levels are matched." : "Their levels are as they are.");
    ["a", "b", "x"].forEach((name, sound) => element(`play-${name}`).onclick = () => this.play(name, sound));
    element("stop").onclick = () => this.stop();
    element("answer-a").onclick = () => this.answer(0);
    element("answer-b").onclick = () => this.answer(1);
    element("again").onclick = () => this.begin();
    const keys = {a: "play-a", b: "play-b", x: "play-x", s: "stop", 1: "answer-a", 2: "answer-b"};
    addEventListener("keydown", event => {
      const id = keys[event.key.toLowerCase()];
      if (id && !event.repeat && !event.ctrlKey && !event.metaKey && !event.altKey) element(id).click();
    });
    this.begin();
  }

  begin() {
    this.answered = this.right = 0;
    element("result").textContent = "";
    element("again").hidden = true;
    this.toss();
  }

  /// The next trial: X is A or B by chance. It can be answered as soon as X was heard.
  toss() {
    this.x = coin();
    this.allowAnswers(false);
    element("trial").textContent = `Trial ${this.answered + 1} of ${page.trials}`;
  }

  allowAnswers(allowed) {
    element("answer-a").disabled = element("answer-b").disabled = !allowed;
  }

  /// @param sound  0, 1, or 2 for X
  async play(name, sound) {
    this.mark(name);
    await this.player.play(sound === 2 ? this.x : sound, () => this.mark(""));
    if (sound === 2 && this.answered < page.trials) this.allowAnswers(true);
  }

  stop() {
    this.player.stop();
    this.mark("");
  }

  mark(playing) {
    for (const name of ["a", "b", "x"]) element(`play-${name}`).classList.toggle("playing", name === playing);
  }

  answer(sound) {
    this.stop();
    ++this.answered;
    if (sound === this.x) ++this.right;
    if (this.answered < page.trials) this.toss();
    else this.finish();
  }

  /// Nothing is told before all trials are answered: who stops at a lucky moment proves nothing.
  finish() {
    this.allowAnswers(false);
    element("trial").textContent = "Done.";
    const chance = chanceByGuessing(this.right, page.trials);
    element("result").textContent = `${this.right} of ${page.trials} answers were right. By guessing, so many or more are right with ` +
      `a probability of ${chance.toPrecision(2)}. ` +
      (chance < 0.05 ? "You can tell the sounds apart." : "This does not show that you can tell the sounds apart.");
    element("again").hidden = false;
  }
}

addEventListener("unhandledrejection", ({reason}) => element("trial").textContent = `This browser can't play it: ${reason.message}`);
window.idiophone = {abx: new Abx(), chanceByGuessing};
