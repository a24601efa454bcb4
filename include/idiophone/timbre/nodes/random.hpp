#pragma once
// Random numbers that are functions of a seed and a counter, so that they do not depend on the order of computing.

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace idiophone::timbre {

/// A permutation of the 64-bit numbers that looks random (SplitMix64: Steele, Lea and Flood 2014).
[[nodiscard]] inline std::uint64_t scrambled(std::uint64_t number) {
  number += 0x9e3779b97f4a7c15U;
  number = (number ^ (number >> 30U)) * 0xbf58476d1ce4e5b9U;
  number = (number ^ (number >> 27U)) * 0x94d049bb133111ebU;
  return number ^ (number >> 31U);
}

/// The seed that a tree gives as a number; other numbers give other seeds.
[[nodiscard]] inline std::uint64_t seed_of(double number) {
  const bool is_whole = std::abs(number) < 0x1p53 && number == std::floor(number);
  return is_whole ? static_cast<std::uint64_t>(static_cast<std::int64_t>(number))
                  : std::bit_cast<std::uint64_t>(number);
}

/// A seed that is made of two numbers.
[[nodiscard]] inline std::uint64_t joined_seed(std::uint64_t seed, std::uint64_t number) {
  return scrambled(scrambled(seed) ^ number);
}

/// A sequence of independent random numbers.
class Random {
 public:
  explicit Random(std::uint64_t seed) : seed_(scrambled(seed)) {}

  /// From 0 to 1, below 1.
  [[nodiscard]] double uniform(std::int64_t counter) const {
    return static_cast<double>(scrambled(seed_ + static_cast<std::uint64_t>(counter)) >> 11U) * 0x1p-53;
  }

  /// With mean 0 and variance 1 (Box and Muller). It uses the counters 2n and 2n + 1.
  [[nodiscard]] double normal(std::int64_t counter) const {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(2 * counter)));
    return radius * std::cos(2.0 * std::numbers::pi * uniform(2 * counter + 1));
  }

 private:
  std::uint64_t seed_;
};

}  // namespace idiophone::timbre
