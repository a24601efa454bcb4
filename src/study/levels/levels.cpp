#include "idiophone/study/levels/levels.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "idiophone/foundation/spectra/spectrum.hpp"
#include "idiophone/foundation/spectra/transform.hpp"
#include "idiophone/study/levels/weighting.hpp"

namespace idiophone::levels {

namespace {

constexpr int lowest_band = -17;          // 20 Hz
constexpr double longest_spacing = 0.25;  // Hz, of the bins of the energy spectrum
constexpr double fade = 0.1;              // s

/// The sum of the squared samples, by frequency.
struct EnergySpectrum {
  double step = 0.0;             ///< Hz, between bins; bin k is at k steps
  std::vector<double> energies;  ///< [bins]

  /// Of the frequencies between two. A bin reaches half a step to both sides.
  [[nodiscard]] double between(double low, double high) const {
    double sum = 0.0;
    const auto first = static_cast<std::size_t>(low / step + 0.5);
    for (std::size_t bin = first; bin < energies.size(); ++bin) {
      const double begin = (static_cast<double>(bin) - 0.5) * step;
      if (begin >= high) {
        break;
      }
      sum += energies[bin] * (std::min(high, begin + step) - std::max(low, begin)) / step;
    }
    return sum;
  }
};

/// The sound goes on after its end as its mirror image, which fades: where a sound is cut off, silence would make a
/// click. The same before its beginning, if that is inside another sound.
std::vector<double> faded(std::span<const double> samples, double rate, Beginning beginning) {
  const std::size_t count = std::min(samples.size(), static_cast<std::size_t>(fade * rate));
  const auto weight = [&](std::size_t n) {
    const double part = (static_cast<double>(n) + 0.5) / static_cast<double>(count);
    return std::pow(std::cos(0.5 * std::numbers::pi * part), 2);
  };
  std::vector<double> longer;
  for (std::size_t n = count; beginning == Beginning::inside && n-- > 0;) {
    longer.push_back(weight(n) * samples[n]);
  }
  longer.insert(longer.end(), samples.begin(), samples.end());
  for (std::size_t n = 0; n < count; ++n) {
    longer.push_back(weight(n) * samples[samples.size() - 1 - n]);
  }
  return longer;
}

double energy_of(std::span<const double> samples) {
  return std::transform_reduce(samples.begin(), samples.end(), samples.begin(), 0.0);
}

/// Of the faded sound, with the energy of the sound itself.
EnergySpectrum energy_spectrum(std::span<const double> samples, double rate, Beginning beginning) {
  const std::vector<double> longer = faded(samples, rate, beginning);
  const auto least = static_cast<std::size_t>(rate / longest_spacing);
  const std::size_t size = std::bit_ceil(std::max<std::size_t>({longer.size(), least, 2}));
  spectra::Transform transform(size);
  EnergySpectrum spectrum{.step = rate / static_cast<double>(size), .energies = {}};
  for (const auto& bin : transform(longer)) {
    spectrum.energies.push_back(2.0 * std::norm(bin));  // with its mirror image
  }
  spectrum.energies.front() /= 2.0;
  spectrum.energies.back() /= 2.0;
  const double sum = std::reduce(spectrum.energies.begin(), spectrum.energies.end());
  const double factor = sum > 0.0 ? energy_of(samples) / sum : 0.0;
  for (double& energy : spectrum.energies) {
    energy *= factor;
  }
  return spectrum;
}

double nominal_frequency(int band) {
  constexpr std::array<double, 10> rounded = {1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0};
  const int decade = (band + 30) / 10;
  return rounded[static_cast<std::size_t>(band + 30 - 10 * decade)] * std::pow(10.0, decade);
}

}  // namespace

Levels levels_of(std::span<const double> samples, double rate, double reference, Beginning beginning) {
  spectra::require_sound(samples, rate);
  if (samples.empty() || !(reference > 0.0)) {
    throw std::invalid_argument("levels need at least one sample, and a reference above 0");
  }
  const EnergySpectrum spectrum = energy_spectrum(samples, rate, beginning);
  const auto level = [&](double energy, double count) {
    return spectra::decibels(std::sqrt(energy / count) / reference);
  };
  const auto count = static_cast<double>(samples.size());
  double weighted = 0.0;
  for (std::size_t bin = 0; bin < spectrum.energies.size(); ++bin) {
    weighted += spectrum.energies[bin] * std::pow(a_weighting(static_cast<double>(bin) * spectrum.step), 2);
  }
  const auto largest = std::ranges::max(samples, {}, [](double sample) { return std::abs(sample); });
  Levels levels{.equivalent = level(energy_of(samples), count),
                .weighted = level(weighted, count),
                .exposure = level(weighted, rate),
                .peak = spectra::decibels(std::abs(largest) / reference)};
  const double half_band = std::pow(10.0, 0.05);
  for (int band = lowest_band;; ++band) {
    const double middle = 1000.0 * std::pow(10.0, 0.1 * band);
    if (middle * half_band > 0.5 * rate) {
      return levels;
    }
    levels.bands.push_back({.nominal = nominal_frequency(band),
                            .level = level(spectrum.between(middle / half_band, middle * half_band), count)});
  }
}

}  // namespace idiophone::levels
