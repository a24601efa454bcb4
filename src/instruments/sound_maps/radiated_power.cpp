#include "idiophone/instruments/sound_maps/radiated_power.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/instruments/resonators/damped_oscillator.hpp"

namespace idiophone::sound_maps {

namespace {

using Complex = std::complex<double>;
using Pressures = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;  // [modes x directions]

/// State of a mode for the force exp(i W t), less what it has when it only follows the force.
/// @param turning  i W, rad/s
/// @param slope    of the force after its low-pass, 1/s
Complex sounding_state(const resonators::DampedOscillator& oscillator, Complex turning, Complex slope) {
  return oscillator.velocity() *
         (1.0 / (turning - oscillator.exponent()) - oscillator.static_state() - slope * oscillator.rising_state());
}

/// Factors of the modes' pressures for the force exp(i W t), [modes] m sqrt(kg)/s.
Eigen::RowVectorXcd factors(const SoundMap& map, std::span<const double> participation, double angular_frequency) {
  const Complex turning(0.0, angular_frequency);
  Complex slope = 0.0;
  Eigen::RowVectorXcd result = Eigen::RowVectorXcd::Zero(static_cast<Eigen::Index>(map.modes()));
  for (std::size_t mode = 0; mode < map.modes(); ++mode) {
    const resonators::DampedOscillator oscillator(map.frequency[mode], map.decay(mode));
    if (!oscillator.oscillates()) {
      continue;
    }
    if (slope == 0.0) {  // the low-pass is that of the lowest mode
      slope = turning / (1.0 + turning / oscillator.damped);
    }
    result[static_cast<Eigen::Index>(mode)] = participation[mode] * sounding_state(oscillator, turning, slope);
  }
  return result;
}

}  // namespace

std::vector<double> radiated_power(const SoundMap& map, std::span<const double> participation,
                                   std::span<const double> frequencies) {
  const auto directions = static_cast<Eigen::Index>(map.sphere.direction.size());
  const Eigen::Map<const Pressures> pressures(map.sphere.pressure.data(), static_cast<Eigen::Index>(map.modes()),
                                              directions);
  const Eigen::Map<const Eigen::VectorXd> weights(map.sphere.weight.data(), directions);
  const double scale = map.sphere.distance * map.sphere.distance / (2.0 * map.air_density * map.air_speed);
  std::vector<double> power;
  for (const double frequency : frequencies) {
    const double angular = 2.0 * std::numbers::pi * frequency;
    // A cosine is the mean of both turns, and its sound the real part of each.
    const Eigen::RowVectorXcd pressure = 0.5 * (factors(map, participation, angular) * pressures +
                                                (factors(map, participation, -angular) * pressures).conjugate());
    power.push_back(scale * pressure.cwiseAbs2().dot(weights.transpose()));
  }
  return power;
}

std::vector<double> frequencies_with_peaks(const SoundMap& map) {
  constexpr double in_an_octave = 48.0;
  std::vector<double> frequencies = map.frequency;
  const double highest = map.frequency.back();
  for (double frequency = 0.5 * map.frequency.front(); frequency < highest;
       frequency *= std::exp2(1.0 / in_an_octave)) {
    frequencies.push_back(frequency);
  }
  std::ranges::sort(frequencies);
  return frequencies;
}

}  // namespace idiophone::sound_maps
