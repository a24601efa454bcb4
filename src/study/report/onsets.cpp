#include "onsets.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "idiophone/foundation/spectra/spectrum.hpp"
#include "idiophone/study/levels/weighting.hpp"

namespace idiophone::report {

namespace {

constexpr double block_length = 0.02;  // s
constexpr std::size_t hops_in_block = 4;
constexpr std::size_t nearest_before = 4;  // hops: the block before that has no sample in common
constexpr std::size_t farthest_before = 20;
constexpr double range = 60.0;         // dB
constexpr double lowest_edge = 100.0;  // Hz, the upper one of the lowest band
constexpr double least_rise = 6.0;     // dB, mean of the bands

/// A-weighted levels of the octave bands in one block, dB.
std::vector<double> band_levels(std::span<const double> block, double rate) {
  const spectra::Spectrum spectrum = spectra::spectrum(block, rate);
  std::vector<double> energies;
  double edge = lowest_edge;
  energies.push_back(0.0);
  for (std::size_t bin = 1; bin < spectrum.level.size(); ++bin) {
    const double frequency = static_cast<double>(bin) * spectrum.frequency_step;
    for (; frequency >= edge; edge *= 2.0) {
      energies.push_back(0.0);
    }
    energies.back() += std::pow(levels::a_weighting(frequency), 2) * std::pow(10.0, 0.1 * spectrum.level[bin]);
  }
  std::ranges::transform(energies, energies.begin(),
                         [](double energy) { return 10.0 * std::log10(std::max(energy, 1e-40)); });
  return energies;
}

/// Levels of all blocks above a floor: [blocks][bands]. The sound begins after two blocks of silence; where it ends, it
/// is cut off, which is no blow.
std::vector<std::vector<double>> levels_over_time(std::span<const double> samples, double rate, std::size_t hop) {
  const std::size_t size = hops_in_block * hop;
  std::vector<double> padded(2 * size, 0.0);
  padded.insert(padded.end(), samples.begin(), samples.end());
  std::vector<std::vector<double>> levels;
  double loudest = -400.0;
  for (std::size_t first = 0; first + size <= padded.size(); first += hop) {
    levels.push_back(band_levels(std::span(padded).subspan(first, size), rate));
    loudest = std::max(loudest, std::ranges::max(levels.back()));
  }
  for (std::vector<double>& block : levels) {
    std::ranges::transform(block, block.begin(), [&](double level) { return std::max(level, loudest - range); });
  }
  return levels;
}

/// By how much each block is louder than all blocks of the time before it, dB, mean of the bands that are ever heard.
std::vector<double> rises_of(const std::vector<std::vector<double>>& levels) {
  std::vector<double> rises(levels.size(), 0.0);
  std::size_t heard = 0;
  for (std::size_t band = 0; band < levels.front().size(); ++band) {
    const auto level = [&](std::size_t block) { return levels[block][band]; };
    double least = level(0), most = level(0);
    for (std::size_t block = 0; block < levels.size(); ++block) {
      least = std::min(least, level(block));
      most = std::max(most, level(block));
    }
    heard += most > least ? 1 : 0;
    for (std::size_t block = nearest_before; block < levels.size(); ++block) {
      double before = level(block - nearest_before);
      for (std::size_t ago = nearest_before; ago <= std::min(farthest_before, block); ++ago) {
        before = std::max(before, level(block - ago));
      }
      rises[block] += std::max(0.0, level(block) - before);
    }
  }
  std::ranges::transform(rises, rises.begin(),
                         [&](double sum) { return heard > 0 ? sum / static_cast<double>(heard) : 0.0; });
  return rises;
}

}  // namespace

std::vector<double> onsets(std::span<const double> samples, double rate) {
  const auto hop = std::max<std::size_t>(1, static_cast<std::size_t>(block_length * rate / hops_in_block));
  const std::vector<double> rises = rises_of(levels_over_time(samples, rate, hop));
  std::vector<double> times;
  for (std::size_t block = 0; block < rises.size(); ++block) {
    if (rises[block] >= least_rise) {
      // A blow first enters the end of a block. The silence before the sound is two blocks long.
      const std::size_t hops = std::max(block, hops_in_block + 1) - hops_in_block - 1;
      times.push_back(static_cast<double>(hops * hop) / rate);
      block += farthest_before - 1;
    }
  }
  return times;
}

}  // namespace idiophone::report
