// The audio thread: a bow that the pointer draws. The body feels it by itself, so it makes no blows, as a Stroke does.

class Bowing {
  /// @param news    load, speed, and the shares of the modes, {participation}
  /// @param modes   CompiledModes
  /// @param number  of the bow there
  constructor({body, level, news}, modes, number, rate) {
    Object.assign(this, {body, level, modes, number, rate});
    modes.putBow(number, news.shares.participation);
    this.follow(news);
  }

  follow(news) {
    this.news = news;
    this.silence = 0;
    this.modes.leadBow(this.number, news, news.shares.participation);
  }

  end() {
    this.modes.liftBow(this.number);
    this.isOver = true;
  }

  /// None. The bow rests if no news came for some time.
  blows(start, samples) {
    this.silence += samples / this.rate;
    if (!this.isOver && this.silence > longestSilence && this.news.speed > 0) this.follow({...this.news, speed: 0});
    return [];
  }
}
