#include "exposure.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "idiophone/foundation/spectra/spectrum.hpp"
#include "idiophone/study/levels/weighting.hpp"

namespace idiophone::report {

namespace {

constexpr std::size_t samples_of_block = 4096;

/// The time integral of the squared sound in each bin of the spectra, by blocks under Hann windows at half their
/// length.
std::vector<double> energies_of(std::span<const double> samples, double rate) {
  constexpr std::size_t hop = samples_of_block / 2;
  std::vector<double> padded(hop, 0.0);
  padded.insert(padded.end(), samples.begin(), samples.end());
  padded.resize(std::max(padded.size(), samples_of_block));  // where a sound is cut off, silence would make a click
  std::vector<double> energies(samples_of_block / 2 + 1, 0.0);
  for (std::size_t first = 0; first + samples_of_block <= padded.size(); first += hop) {
    const auto block = spectra::spectrum(std::span(padded).subspan(first, samples_of_block), rate);
    for (std::size_t bin = 0; bin < energies.size(); ++bin) {
      energies[bin] += std::pow(10.0, 0.1 * block.level[bin]);
    }
  }
  // The bins of a sine of amplitude 1 sum to 1.5, its mean square is 1/2, and each sample is in 0.75 windows' squares
  // where the levels assume 0.375, the mean square of one.
  const double seconds = static_cast<double>(hop) / rate;
  for (double& energy : energies) {
    energy *= seconds / 3.0;
  }
  return energies;
}

}  // namespace

Exposure exposure(std::span<const double> samples, double rate) {
  std::vector<double> energies = energies_of(samples, rate);
  const double step = rate / samples_of_block;
  for (std::size_t bin = 0; bin < energies.size(); ++bin) {
    energies[bin] *= std::pow(levels::a_weighting(static_cast<double>(bin) * step), 2);
  }
  const double sum = std::accumulate(energies.begin(), energies.end(), 0.0);
  double above = 0.0;
  std::size_t bin = energies.size();
  while (bin > 1 && above + energies[bin - 1] <= 1e-4 * sum) {
    above += energies[--bin];
  }
  return {.level = 10.0 * std::log10(std::max(sum, 1e-40)),
          .highest = std::min(sum > 0.0 ? static_cast<double>(bin) * step : 0.5 * rate, 0.5 * rate)};
}

}  // namespace idiophone::report
