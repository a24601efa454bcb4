#include "known_sounds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "idiophone/timbre/language/graph.hpp"

namespace idiophone::timbre {

namespace {

constexpr double compared = 2.0;  // s

/// Removes what is below the range of hearing: a first-order high-pass at 20 Hz, twice.
void remove_inaudible(std::vector<double>& sound, int rate) {
  const double share = std::exp(-2.0 * std::numbers::pi * 20.0 / rate);
  for (int pass = 0; pass < 2; ++pass) {
    double before = 0.0, output = 0.0;
    for (double& sample : sound) {
      output = share * (output + sample - before);
      before = sample;
      sample = output;
    }
  }
}

double loudest_of(const std::vector<double>& sound) {
  double loudest = 0.0;
  for (const double sample : sound) {
    loudest = std::max(loudest, std::abs(sample));
  }
  return loudest;
}

}  // namespace

KnownSounds::KnownSounds(double duration, int rate)
    : samples_(static_cast<std::size_t>(std::min(duration, compared) * rate)), rate_(rate) {}

void KnownSounds::add(const Tree& tree) {
  std::vector<double> sound = heard(tree);
  if (!sound.empty()) {
    known_.emplace_back(Target{.samples = std::move(sound), .rate = rate_});
  }
}

bool KnownSounds::add_if_new(const Tree& tree) {
  std::vector<double> sound;
  try {
    sound = heard(tree);
  } catch (const std::runtime_error&) {  // a sample that is not finite
    return false;
  }
  if (sound.empty()) {
    return false;
  }
  SoundDistance candidate({.samples = std::move(sound), .rate = rate_});
  if (std::ranges::any_of(known_, [&](const SoundDistance& known) { return known.to(candidate) < audible_distance; })) {
    return false;
  }
  known_.push_back(std::move(candidate));
  return true;
}

std::vector<double> KnownSounds::heard(const Tree& tree) const {
  std::vector<double> sound(samples_);
  Graph(tree, {}, {.rate = rate_}).render(sound);
  const double all = loudest_of(sound);
  remove_inaudible(sound, rate_);
  const double loudest = loudest_of(sound);
  if (loudest <= 1e-3 * all) {  // what is left of a slow motion is not a sound
    return {};
  }
  for (double& sample : sound) {
    sample /= loudest;
  }
  return sound;
}

}  // namespace idiophone::timbre
