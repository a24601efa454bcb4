#include "idiophone/foundation/spectra/spectrum.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "idiophone/foundation/spectra/transform.hpp"

namespace idiophone::spectra {
namespace {

/// Amplitude spectra of blocks of one size under a Hann window.
class HannSpectrum {
 public:
  explicit HannSpectrum(std::size_t size) : transform_(size), window_(size), windowed_(size) {
    for (std::size_t n = 0; n < size; ++n) {
      const double sine = std::sin(std::numbers::pi * static_cast<double>(n) / static_cast<double>(size));
      window_[n] = sine * sine;
    }
    scale_ = 2.0 / std::accumulate(window_.begin(), window_.end(), 0.0);
  }

  /// Appends the block's levels, [size / 2 + 1] dB.
  void append(std::span<const double> block, std::vector<double>& level) {
    std::ranges::transform(block, window_, windowed_.begin(), std::multiplies<>());
    const auto bins = transform_(windowed_);
    for (std::size_t k = 0; k < bins.size(); ++k) {
      // 0 Hz and half the rate have no mirror image to share their amplitude with.
      const double share = k == 0 || 2 * k == block.size() ? 0.5 : 1.0;
      level.push_back(decibels(share * scale_ * std::abs(bins[k])));
    }
  }

 private:
  Transform transform_;
  std::vector<double> window_, windowed_;
  double scale_ = 0.0;
};

}  // namespace

double decibels(double amplitude) {
  return amplitude > 0.0 ? std::max(20.0 * std::log10(amplitude), silence) : silence;
}

Spectrum spectrum(std::span<const double> samples, double rate) {
  require_sound(samples, rate);
  if (samples.size() < 2) {
    throw std::invalid_argument(fmt::format("a spectrum needs at least 2 samples, there are {}", samples.size()));
  }
  Spectrum result{.frequency_step = rate / static_cast<double>(samples.size()), .level = {}};
  HannSpectrum(samples.size()).append(samples, result.level);
  return result;
}

Spectrogram spectrogram(std::span<const double> samples, double rate, const SpectrogramOptions& options) {
  require_sound(samples, rate);
  if (options.block < 2 || options.hop < 1) {
    throw std::invalid_argument(
        fmt::format("a spectrogram needs blocks of at least 2 samples and a hop of at least 1, "
                    "not {} and {}",
                    options.block, options.hop));
  }
  if (samples.size() < options.block) {
    throw std::invalid_argument(fmt::format(
        "the sound has {} samples, less than one block of {}: choose shorter blocks", samples.size(), options.block));
  }
  const auto block = static_cast<double>(options.block);
  Spectrogram result{.frequency_step = rate / block,
                     .time_step = static_cast<double>(options.hop) / rate,
                     .first_time = 0.5 * block / rate,
                     .bins = options.block / 2 + 1,
                     .blocks = (samples.size() - options.block) / options.hop + 1,
                     .level = {}};
  result.level.reserve(result.bins * result.blocks);
  HannSpectrum spectrum_of(options.block);
  for (std::size_t b = 0; b < result.blocks; ++b) {
    spectrum_of.append(samples.subspan(b * options.hop, options.block), result.level);
  }
  return result;
}

}  // namespace idiophone::spectra
