// Pictures of the energy of a sound over time and frequency, and their colours.

const darkScheme = window.matchMedia("(prefers-color-scheme: dark)");

/// Loud is dark on a light page, and bright on a dark one. @return  red, green and blue, 0 to 255
function shade(part) {
  const p = Math.min(1, Math.max(0, part));
  return darkScheme.matches ? [22 + 233 * p ** 0.9, 24 + 205 * p ** 1.8, 28 + 120 * Math.sin(2.2 * p) ** 2 + 60 * p ** 4]
                            : [255 * (1 - p ** 0.8), 255 * (1 - p) ** 1.3, 255 * (1 - 0.75 * p ** 1.5)];
}

/// Sums a spectrum of energies between frequencies that are given as places among the bins. A bin reaches to the middle
/// of the next one.
function summed(energies) {
  const sums = new Float64Array(energies.length + 1);
  energies.forEach((energy, k) => sums[k + 1] = sums[k] + energy);
  return place => {
    const p = Math.min(energies.length, Math.max(0, place + 0.5)), k = Math.min(energies.length - 1, Math.floor(p));
    return sums[k] + (p - k) * energies[k];
  };
}

/// Mean energies of a sound between two times, s, in each bin of blocks under a Hann window. No block reaches beyond the
/// end, where a sound that is cut off would make a click.
/// @return [size/2 + 1] re a sine of amplitude 1
function meanEnergies({samples, rate}, from, to, size) {
  const blocks = Math.max(1, Math.ceil((to - from) * rate / (size / 2))), last = Math.max(0, samples.length - size);
  const energies = new Float64Array(size / 2 + 1);
  for (let block = 0; block < blocks; ++block) {
    const middle = (from + (block + 0.5) / blocks * (to - from)) * rate;
    const part = amplitudes(samples, Math.min(last, Math.round(middle - size / 2)), size, size);
    for (let k = 0; k < energies.length; ++k) energies[k] += part[k] ** 2 / (1.5 * blocks);  // the window's noise bandwidth
  }
  return energies;
}

/// Levels of all pixels, dB re a sine of amplitude 1: the mean energy in the time of a pixel, summed over its frequencies.
/// @param time, frequency  ranges, s and Hz
/// @return  values: [rows][columns] from the highest frequency on; loudest of them
function energyPicture(sound, time, frequency, columns, rows) {
  const resolution = (frequency.high - frequency.low) / 250;  // Hz
  const length = Math.min(0.1 * (time.high - time.low), Math.max(1 / resolution, 0.01)) * sound.rate;
  const size = Math.min(16384, Math.max(256, powerOfTwo(length)));
  const values = new Float32Array(columns * rows), width = (time.high - time.low) / columns;
  let loudest = -400;
  for (let column = 0; column < columns; ++column) {
    const from = time.low + column * width, sum = summed(meanEnergies(sound, from, from + width, size));
    const upTo = row => sum((frequency.high - row / rows * (frequency.high - frequency.low)) * size / sound.rate);
    for (let row = 0; row < rows; ++row) {
      const level = 10 * Math.log10(Math.max(1e-40, upTo(row) - upTo(row + 1)));
      values[row * columns + column] = level;
      loudest = Math.max(loudest, level);
    }
  }
  return {values, loudest};
}
