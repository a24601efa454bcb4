#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "idiophone/analysis/spectrum.hpp"
#include "idiophone/timbre/evolution.hpp"
#include "sound_file.hpp"

namespace idiophone::timbre {

namespace {

constexpr double dynamic_range = 60.0;  // dB

/// Root mean square of the differences, levels below the floor raised to it.
double rms_difference(const std::vector<double>& a, const std::vector<double>& b, double floor) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = std::max(a[i], floor) - std::max(b[i], floor);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Levels of blocks of 256 samples, dB.
std::vector<double> envelope(const std::vector<double>& sound) {
  constexpr std::size_t block = 256;
  std::vector<double> levels;
  for (std::size_t begin = 0; begin + block <= sound.size(); begin += block) {
    double sum = 0.0;
    for (std::size_t i = begin; i < begin + block; ++i) {
      sum += sound[i] * sound[i];
    }
    levels.push_back(analysis::decibels(std::sqrt(sum / block)));
  }
  return levels;
}

double spectral_distance(const std::vector<double>& sound, const Target& target, std::size_t block) {
  const analysis::SpectrogramOptions options{.block = block, .hop = block / 2};
  const auto levels = analysis::spectrogram(sound, target.rate, options).level;
  const auto wanted = analysis::spectrogram(target.samples, target.rate, options).level;
  return rms_difference(levels, wanted, *std::ranges::max_element(wanted) - dynamic_range);
}

}  // namespace

Target read_target(const std::filesystem::path& file, int rate) {
  Target target{.samples = read_sound_file(file, rate), .rate = rate};
  constexpr std::size_t shortest = 4096;  // two of the longest blocks
  if (target.samples.size() < shortest) {
    throw std::runtime_error(file.string() + ": too short to be imitated; it needs at least 4096 samples");
  }
  return target;
}

double sound_distance(const std::vector<double>& sound, const Target& target) {
  const std::vector<double> wanted = envelope(target.samples);
  return spectral_distance(sound, target, 2048) + spectral_distance(sound, target, 256) +
         rms_difference(envelope(sound), wanted, *std::ranges::max_element(wanted) - dynamic_range);
}

}  // namespace idiophone::timbre
