#pragma once
// What the sound of modes has to be without: what they do when they only follow a force.

#include <array>
#include <cstddef>
#include <span>

#include "mode_groups.hpp"

namespace idiophone::resonators {

/// A complex number for each mode of a pack.
struct ComplexPack {
  ModePack real, imaginary;
};

inline ComplexPack quotient(const ComplexPack& a, const ComplexPack& b) {
  const ModePack square = b.real * b.real + b.imaginary * b.imaginary;
  return {(a.real * b.real + a.imaginary * b.imaginary) / square,
          (a.imaginary * b.real - a.real * b.imaginary) / square};
}

/// What each output would get of modes that follow a force of 1, and one that rises by 1 in a sample.
template <std::size_t outputs>
struct FollowingSound {
  std::array<ModePack, outputs> of_force{}, of_rise{};
};

/// In the steady state z(n) = a F(n) + b of a force that rises by 1 in each sample, z(n + 1) = turn z(n) + by_mean mean
/// + by_slope slope gives a (1 - turn) = by_mean and b (1 - turn) = (by_mean + by_slope)/2 - a.
template <std::size_t outputs>
FollowingSound<outputs> following_sound(const Drive& drive, std::span<const ModeGroup> turns,
                                        std::span<const ModeGroup> gains) {
  FollowingSound<outputs> sums;
  for (std::size_t group = 0; group < turns.size(); ++group) {
    const ModeGroup &mean = drive.by_mean[group], &slope = drive.by_slope[group];
    for (std::size_t p = 0; p < packs_in_group; ++p) {
      const ComplexPack rest{1.0 - turns[group].real[p], -turns[group].imaginary[p]};
      const ComplexPack a = quotient({mean.real[p], mean.imaginary[p]}, rest);
      const ComplexPack b = quotient(
          {0.5 * (mean.real[p] + slope.real[p]) - a.real, 0.5 * (mean.imaginary[p] + slope.imaginary[p]) - a.imaginary},
          rest);
      for (std::size_t o = 0; o < outputs; ++o) {
        const ModeGroup& gain = gains[o * turns.size() + group];
        sums.of_force[o] += gain.real[p] * a.real - gain.imaginary[p] * a.imaginary;
        sums.of_rise[o] += gain.real[p] * b.real - gain.imaginary[p] * b.imaginary;
      }
    }
  }
  return sums;
}

/// Takes away what the modes do when they only follow a force.
template <std::size_t outputs>
void take_following_sound(const Drive& drive, std::span<const ModeGroup> turns, std::span<const ModeGroup> gains,
                          std::span<double> sound) {
  const FollowingSound<outputs> sums = following_sound<outputs>(drive, turns, gains);
  for (std::size_t o = 0; o < outputs; ++o) {
    const double of_force = sum_of_lanes(sums.of_force[o]), of_rise = sum_of_lanes(sums.of_rise[o]);
    for (std::size_t i = 0; i < drive.force.size(); ++i) {
      sound[i * outputs + o] -= drive.force[i].begin * of_force + drive.force[i].rise * of_rise;
    }
  }
}

}  // namespace idiophone::resonators
