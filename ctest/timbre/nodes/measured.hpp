#pragma once
// What is measured of the sounds of nodes.

#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "sounding.hpp"

namespace idiophone::timbre {

/// The tree of a sound that is 1 in its first sample and 0 from then on.
inline const std::string impulse = "(timer 0 0.00001 1)";

/// Sum of the samples times exp(-2 pi i f n): of an impulse response, the response.
/// @param frequency  f, cycles per sample
inline std::complex<double> response(const std::vector<double>& sound, double frequency) {
  const auto turned = [frequency](std::size_t samples) {
    return std::polar(1.0, -2.0 * std::numbers::pi * frequency * static_cast<double>(samples));
  };
  const std::complex<double> step = turned(1);
  std::complex<double> sum, turn;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    turn = i % 64 == 0 ? turned(i) : turn * step;  // a product of many steps would lose digits
    sum += sound[i] * turn;
  }
  return sum;
}

/// Complex amplitude of the line at a frequency in cycles per sample.
inline std::complex<double> line(const std::vector<double>& sound, double frequency) {
  return 2.0 / static_cast<double>(sound.size()) * response(sound, frequency);
}

inline double mean(const std::vector<double>& sound) {
  return std::accumulate(sound.begin(), sound.end(), 0.0) / static_cast<double>(sound.size());
}

/// Mean of the products of samples that are `lag` samples apart.
inline double correlation(const std::vector<double>& sound, std::size_t lag) {
  const auto end = sound.end() - static_cast<std::ptrdiff_t>(lag);
  return std::inner_product(sound.begin(), end, sound.begin() + static_cast<std::ptrdiff_t>(lag), 0.0) /
         static_cast<double>(sound.size() - lag);
}

inline double mean_square(const std::vector<double>& sound) {
  return correlation(sound, 0);
}

}  // namespace idiophone::timbre
