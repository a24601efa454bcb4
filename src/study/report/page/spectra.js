// Spectra of the part of a sound that is shown, computed in the page.

/// Fast Fourier transform in place; the length is a power of two.
function transform(real, imaginary) {
  const length = real.length;
  for (let i = 1, j = 0; i < length; ++i) {
    let bit = length >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) {
      [real[i], real[j]] = [real[j], real[i]];
      [imaginary[i], imaginary[j]] = [imaginary[j], imaginary[i]];
    }
  }
  for (let size = 2; size <= length; size *= 2) {
    const half = size / 2, angle = -2 * Math.PI / size;
    for (let k = 0; k < half; ++k) {
      const c = Math.cos(angle * k), s = Math.sin(angle * k);
      for (let a = k; a < length; a += size) {
        const b = a + half, x = real[b] * c - imaginary[b] * s, y = real[b] * s + imaginary[b] * c;
        real[b] = real[a] - x;
        imaginary[b] = imaginary[a] - y;
        real[a] += x;
        imaginary[a] += y;
      }
    }
  }
}

/// Amplitudes of a part of the samples under a Hann window.
/// @param size  a power of two of at least `count`
/// @return [size/2 + 1], bin k at k rate/size
function amplitudes(samples, first, count, size) {
  const real = new Float64Array(size), imaginary = new Float64Array(size);
  let sum = 0;
  for (let n = 0; n < count; ++n) {
    const weight = 0.5 - 0.5 * Math.cos(2 * Math.PI * (n + 0.5) / count);
    real[n] = weight * (samples[first + n] || 0);
    sum += weight;
  }
  transform(real, imaginary);
  const found = new Float32Array(size / 2 + 1);
  for (let k = 0; k < found.length; ++k) found[k] = 2 * Math.sqrt(real[k] ** 2 + imaginary[k] ** 2) / sum;
  return found;
}

/// The same in dB re an amplitude of 1.
function levels(samples, first, count, size) {
  return amplitudes(samples, first, count, size).map(amplitude => 20 * Math.log10(Math.max(1e-20, amplitude)));
}

const powerOfTwo = count => 2 ** Math.ceil(Math.log2(Math.max(2, count)));

/// Spectrogram and spectrum of one channel; both show the same frequencies and the same part of the sound.
class Spectra {
  /// @param spectrogram, spectrum  canvases
  constructor(spectrogram, spectrum) {
    this.time = new Range(0, 1);
    this.frequency = new Range(0, 1);
    this.level = new Range(-80, 0);
    this.span = 80;  // dB
    const changed = () => this.request();
    this.above = new Plot(spectrogram, {x: this.time, y: this.frequency, xLabel: "time (s)", yLabel: "frequency (Hz)",
                                        zoomable: ["x", "y"], right: 62, changed});
    this.below = new Plot(spectrum, {x: this.frequency, y: this.level, xLabel: "frequency (Hz)", yLabel: "level (dB)",
                                     zoomable: ["x"], changed});
    window.addEventListener("resize", changed);
    darkScheme.addEventListener("change", changed);
  }

  /// @param channels  the first is shown as spectrogram, all as spectra: {samples, rate, highest, partials, line}
  /// @param times     of impacts, s
  show(channels, references, times) {
    const [{samples, rate, highest, partials}] = channels;
    Object.assign(this, {channels, references, times});
    Object.assign(this.time, new Range(0, samples.length / rate));
    Object.assign(this.frequency, new Range(0, rate / 2));
    const needed = Math.max(1000, highest, ...partials.map(({frequency}) => frequency));
    this.frequency.high = Math.min(rate / 2, 1.2 * needed);
    this.request();
  }

  /// Shows the sound from one time to another, s.
  showTime(from, to) {
    [this.time.low, this.time.high] = [Math.max(0, from), Math.min(to, this.time.bounds[1])];
    this.request();
  }

  whole() {
    this.time.reset();
    this.frequency.reset();
    this.request();
  }

  /// Draws once before the next picture of the screen.
  request() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.drawSpectrum();
      this.drawSpectrogram();
      this.drawn = (this.drawn || 0) + 1;
    });
  }

  drawSpectrum() {
    const {below, time, level} = this;
    below.begin();
    const lines = this.channels.map(({samples, rate, line}) => {
      const first = Math.max(0, Math.floor(time.low * rate));
      const count = Math.min(Math.ceil((time.high - time.low) * rate), 2 ** 18, samples.length - first);
      const size = 2 * powerOfTwo(count);
      return {line, step: rate / size, values: levels(samples, first, count, size)};
    });
    const top = Math.max(...lines.map(({values}) => values.reduce((most, value) => Math.max(most, value), -400)));
    Object.assign(level, new Range(Math.floor(top) - this.span, Math.ceil(top) + 4));
    below.axes();
    this.drawMarks();
    for (const {line, step, values} of lines) this.drawEnvelope(values, step, theme(line));
  }

  /// The highest value under each pixel.
  drawEnvelope(values, step, colour) {
    const {below, frequency} = this, xs = [], ys = [];
    for (let pixel = 0; pixel <= below.width; ++pixel) {
      const low = frequency.low + (pixel - 0.5) / below.width * (frequency.high - frequency.low);
      const high = low + (frequency.high - frequency.low) / below.width;
      const from = Math.max(0, Math.round(low / step)), to = Math.min(values.length - 1, Math.max(from, Math.round(high / step)));
      let most = -400;
      for (let k = from; k <= to; ++k) most = Math.max(most, values[k]);
      xs.push((low + high) / 2);
      ys.push(most);
    }
    below.line(xs, ys, colour);
  }

  /// Expected frequencies as dashed lines, partials as ticks at the top.
  drawMarks() {
    const {below} = this, {top} = below.margin;
    below.within(pen => {
      pen.strokeStyle = theme("--expected");
      pen.setLineDash([4, 4]);
      for (const {frequencies} of this.references) {
        for (const hertz of frequencies) pen.strokeRect(below.left(hertz), top, 0, below.height);
      }
      pen.setLineDash([]);
      pen.fillStyle = theme("--mark");
      for (const {frequency} of this.channels[0].partials) pen.fillRect(below.left(frequency) - 1, top, 2, 8);
    });
  }

  drawSpectrogram() {
    const {above, time, frequency} = this;
    above.begin();
    const columns = Math.max(1, Math.min(Math.floor(above.width), 700)), rows = Math.max(1, Math.floor(above.height));
    const {values, loudest} = energyPicture(this.channels[0], time, frequency, columns, rows);
    const picture = new ImageData(columns, rows);
    values.forEach((level, pixel) => picture.data.set([...shade(1 + (level - loudest) / this.span), 255], 4 * pixel));
    const canvas = new OffscreenCanvas(columns, rows);
    canvas.getContext("2d").putImageData(picture, 0, 0);
    above.within(pen => pen.drawImage(canvas, above.margin.left, above.margin.top, above.width, above.height));
    above.axes();
    this.drawTimes();
    this.drawScale(loudest);
  }

  /// The colours of the levels, beside the spectrogram.
  drawScale(loudest) {
    const {pen, margin, width, height} = this.above, left = margin.left + width + 10, thick = 12;
    const scale = new Range(loudest - this.span, loudest), top = level => margin.top + height * (1 - scale.toPart(level));
    for (let y = 0; y < height; ++y) {
      pen.fillStyle = `rgb(${shade(1 - y / height).map(Math.round).join(" ")})`;
      pen.fillRect(left, margin.top + y, thick, 1);
    }
    pen.strokeStyle = pen.fillStyle = theme("--quiet");
    pen.strokeRect(left, margin.top, thick, height);
    pen.textAlign = "left";
    for (const level of ticks(scale.low, scale.high, height / 40)) pen.fillText(short(level), left + thick + 4, top(level) + 4);
    pen.fillText("dB", left, margin.top + height + 31);
  }

  /// Impacts as ticks at the top.
  drawTimes() {
    const {above} = this;
    above.within(pen => {
      pen.fillStyle = theme("--mark");
      for (const time of this.times) pen.fillRect(above.left(time) - 1, above.margin.top, 2, 8);
    });
  }
}
