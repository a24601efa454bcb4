#pragma once
// Spectra and spectrograms of sampled sound, in decibels.

#include <cstddef>
#include <span>
#include <vector>

namespace idiophone::spectra {

/// The level of zero amplitude, dB; no level is below it.
inline constexpr double silence = -400.0;

/// 20 log10(amplitude), dB re one unit of the samples, but not below `silence`.
[[nodiscard]] double decibels(double amplitude);

/// Amplitudes over frequency. A sine of amplitude 1 at the frequency of a bin has 0 dB there (at most 1.42 dB less
/// between two bins).
struct Spectrum {
  double frequency_step = 0.0;  ///< between two bins, Hz; bin 0 is 0 Hz
  std::vector<double> level;    ///< [samples / 2 + 1] dB re one unit of the samples
};

/// Spectrum of all samples under a Hann window.
/// @param samples  [samples] in any unit
/// @param rate     samples per second
/// @throws std::invalid_argument for fewer than 2 samples, a sample that is not finite, or a rate that is not positive.
[[nodiscard]] Spectrum spectrum(std::span<const double> samples, double rate);

/// Division of the sound into blocks, each under a Hann window.
struct SpectrogramOptions {
  std::size_t block = 2048;  ///< samples in a block, at least 2
  std::size_t hop = 512;     ///< samples between the beginnings of two blocks, at least 1
};

/// Spectra of overlapping blocks.
struct Spectrogram {
  double frequency_step = 0.0;  ///< between two bins, Hz; bin 0 is 0 Hz
  double time_step = 0.0;       ///< between two blocks, s
  double first_time = 0.0;      ///< s, the middle of the first block
  std::size_t bins = 0;         ///< block / 2 + 1
  std::size_t blocks = 0;       ///< whole blocks in the sound
  std::vector<double> level;    ///< [bins x blocks], bins of one block are contiguous, dB re one unit of the samples
};

/// Short-time Fourier transform. The last samples that do not fill a block are ignored.
/// @throws std::invalid_argument as spectrum() does, and for a sound shorter than a block.
[[nodiscard]] Spectrogram spectrogram(std::span<const double> samples, double rate,
                                      const SpectrogramOptions& options = {});

}  // namespace idiophone::spectra
