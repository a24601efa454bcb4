#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "idiophone/foundation/spectra/resampled_sound.hpp"
#include "idiophone/foundation/spectra/spectrum.hpp"
#include "idiophone/timbre/evolution/evolution.hpp"

namespace idiophone::timbre {

namespace {

constexpr double dynamic_range = 60.0;  // dB
constexpr std::size_t fine_block = 2048, coarse_block = 256;

/// Levels of blocks of 256 samples, dB.
std::vector<double> envelope(const std::vector<double>& sound) {
  constexpr std::size_t block = 256;
  std::vector<double> levels;
  for (std::size_t begin = 0; begin + block <= sound.size(); begin += block) {
    double sum = 0.0;
    for (std::size_t i = begin; i < begin + block; ++i) {
      sum += sound[i] * sound[i];
    }
    levels.push_back(spectra::decibels(std::sqrt(sum / block)));
  }
  return levels;
}

}  // namespace

Target read_target(const std::filesystem::path& file, int rate) {
  Target target{.samples = spectra::read_sound_file(file, rate), .rate = rate};
  constexpr std::size_t shortest = 4096;  // two of the longest blocks
  if (target.samples.size() < shortest) {
    throw std::runtime_error(file.string() + ": too short to be imitated; it needs at least 4096 samples");
  }
  return target;
}

SoundDistance::SoundDistance(const Target& target)
    : rate_(target.rate),
      fine_(with_floor(spectra(target.samples, fine_block))),
      coarse_(with_floor(spectra(target.samples, coarse_block))),
      envelope_(with_floor(envelope(target.samples))) {}

SoundDistance::Levels SoundDistance::with_floor(std::vector<double> wanted) {
  const double loudest = *std::ranges::max_element(wanted);
  return {std::move(wanted), loudest - dynamic_range};
}

std::vector<double> SoundDistance::spectra(const std::vector<double>& sound, std::size_t block) const {
  return spectra::spectrogram(sound, rate_, {.block = block, .hop = block / 2}).level;
}

double SoundDistance::Levels::rms_difference(const std::vector<double>& levels) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double difference = std::max(levels[i], floor) - std::max(wanted[i], floor);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(levels.size()));
}

double SoundDistance::operator()(const std::vector<double>& sound) const {
  return fine_.rms_difference(spectra(sound, fine_block)) + coarse_.rms_difference(spectra(sound, coarse_block)) +
         envelope_.rms_difference(envelope(sound));
}

double SoundDistance::to(const SoundDistance& other) const {
  return fine_.rms_difference(other.fine_.wanted) + coarse_.rms_difference(other.coarse_.wanted) +
         envelope_.rms_difference(other.envelope_.wanted);
}

}  // namespace idiophone::timbre
