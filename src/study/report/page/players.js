// Sounds: decoded samples, players, and two sounds of which one is heard.

/// @param channel  as the program writes it (src/study/report/page_sounds.cpp); gets its samples, in its unit
function readChannel(channel) {
  const whole = decoded(channel.samples, Int16Array);
  return {...channel, samples: Float32Array.from(whole, value => value * channel.loudest / 32767)};
}

/// A WAV file of 16 bits whose loudest sample is full scale.
function wavOf(channels) {
  const count = channels.length, frames = channels[0].samples.length, rate = channels[0].rate;
  const view = new DataView(new ArrayBuffer(44 + 2 * count * frames));
  const text = (at, letters) => [...letters].forEach((letter, i) => view.setUint8(at + i, letter.charCodeAt(0)));
  text(0, "RIFF");
  view.setUint32(4, 36 + 2 * count * frames, true);
  text(8, "WAVEfmt ");
  view.setUint32(16, 16, true);
  view.setUint16(20, 1, true);
  view.setUint16(22, count, true);
  view.setUint32(24, rate, true);
  view.setUint32(28, 2 * count * rate, true);
  view.setUint16(32, 2 * count, true);
  view.setUint16(34, 16, true);
  text(36, "data");
  view.setUint32(40, 2 * count * frames, true);
  const scale = 32767 / Math.max(1e-30, ...channels.map(({loudest}) => loudest));
  for (let n = 0; n < frames; ++n) {
    channels.forEach(({samples}, c) => view.setInt16(44 + 2 * (n * count + c), Math.round(samples[n] * scale), true));
  }
  return new Blob([view.buffer], {type: "audio/wav"});
}

/// Channels of one listener: "ears.left" and "ears.right" belong to "ears".
function listenersOf(channels) {
  const byName = new Map();
  for (const channel of channels) {
    const name = channel.name.replace(/\.(left|right)$/, "");
    byName.set(name, [...(byName.get(name) || []), channel]);
  }
  return byName;
}

function addPlayer(parent, label, channels) {
  const line = document.createElement("div"), name = document.createElement("span"), audio = document.createElement("audio");
  line.className = "player";
  name.textContent = label;
  audio.controls = true;
  audio.setAttribute("aria-label", label);
  audio.src = URL.createObjectURL(wavOf(channels));
  line.append(name, audio);
  parent.append(line);
}

/// Plays two channels together at equal exposure; one of them is heard.
class TwoSounds {
  constructor(first, second) {
    this.sounds = [first, second];
    this.heard = 0;
  }

  async play() {
    this.stop();
    this.context ??= new AudioContext();
    await this.context.resume();
    const quietest = Math.min(...this.sounds.map(({exposure}) => exposure));
    const factors = this.sounds.map(({exposure}) => 10 ** ((quietest - exposure) / 20));
    const peak = Math.max(...this.sounds.map(({loudest}, i) => loudest * factors[i]));
    this.playing = this.sounds.map(({samples, rate}, i) => {
      const buffer = this.context.createBuffer(1, samples.length, rate);
      buffer.copyToChannel(samples.map(value => 0.9 * value * factors[i] / peak), 0);
      const source = new AudioBufferSourceNode(this.context, {buffer, loop: true});
      const gain = new GainNode(this.context, {gain: i === this.heard ? 1 : 0});
      source.connect(gain).connect(this.context.destination);
      return {source, gain};
    });
    const start = this.context.currentTime + 0.05;
    this.playing.forEach(({source}) => source.start(start));
  }

  stop() {
    this.playing?.forEach(({source}) => source.stop());
    this.playing = null;
  }

  swap() {
    this.heard = 1 - this.heard;
    this.playing?.forEach(({gain}, i) => gain.gain.setTargetAtTime(i === this.heard ? 1 : 0, this.context.currentTime, 0.005));
  }
}
