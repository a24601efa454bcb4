// The two sounds of the page's data, and their player.

function samplesOf(text) {
  const bytes = Uint8Array.from(atob(text), character => character.charCodeAt(0));
  return new Float32Array(bytes.buffer);
}

/// @param sounds  rate and channels of each, as the program writes them (src/study/abx/abx_page.cpp)
class Player {
  constructor(sounds) {
    this.sounds = sounds.map(({rate, channels}) => ({rate, channels: channels.map(samplesOf)}));
  }

  /// Plays sound 0 or 1 from its beginning, instead of what is playing.
  /// @param ended  is called when it has ended by itself
  async play(number, ended) {
    this.context ??= new AudioContext();
    await this.context.resume();
    this.stop();
    const {rate, channels} = this.sounds[number];
    const buffer = this.context.createBuffer(channels.length, channels[0].length, rate);
    channels.forEach((samples, channel) => buffer.copyToChannel(samples, channel));
    this.source = new AudioBufferSourceNode(this.context, {buffer});
    this.source.connect(this.context.destination);
    this.source.onended = ended;
    this.source.start();
  }

  stop() {
    if (!this.source) return;
    this.source.onended = null;
    this.source.stop();
    this.source = null;
  }
}
