#include "octave_bands.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "idiophone/foundation/spectra/transform.hpp"

namespace idiophone::timbre {

namespace {

/// Gain of a band at a frequency, Hz.
double band_gain(std::size_t band, double frequency) {
  const double last = static_cast<double>(OctaveBands::count) - 1.0;
  const double octave = frequency > 0.0 ? std::clamp(std::log2(frequency / scene::lowest_octave), 0.0, last) : 0.0;
  return std::max(0.0, 1.0 - std::abs(octave - static_cast<double>(band)));
}

/// [2 lead + 1] The inverse transform of the gain, in a window that leaves the middle tap as it is.
std::vector<double> band_response(std::size_t band, int rate, std::size_t lead) {
  const std::size_t size = 16 * lead;
  std::vector<std::complex<double>> spectrum(size / 2 + 1);
  for (std::size_t line = 0; line < spectrum.size(); ++line) {
    spectrum[line] = band_gain(band, static_cast<double>(line) / static_cast<double>(size) * rate);
  }
  const std::vector<double> response = spectra::inverse_transform(std::move(spectrum), size);
  std::vector<double> taps(2 * lead + 1);
  for (std::size_t k = 0; k <= lead; ++k) {
    const double window =
        0.5 + 0.5 * std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(lead + 1));
    taps[lead - k] = taps[lead + k] = window * response[k] / static_cast<double>(size);
  }
  return taps;
}

}  // namespace

OctaveBands::OctaveBands(int rate) {
  for (std::size_t band = 0; band < count; ++band) {
    filters_.emplace_back(band_response(band, rate, lead(rate)));
  }
}

std::size_t OctaveBands::lead(int rate) {
  return static_cast<std::size_t>(std::ceil(4.0 * rate / scene::lowest_octave));
}

std::array<double, OctaveBands::count> OctaveBands::step(double input) {
  std::array<double, count> bands{};
  std::ranges::transform(filters_, bands.begin(), [input](spectra::Convolver& filter) { return filter.step(input); });
  return bands;
}

}  // namespace idiophone::timbre
