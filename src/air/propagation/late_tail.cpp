#include "late_tail.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "idiophone/air/radiation/absorption.hpp"
#include "idiophone/foundation/random_numbers.hpp"
#include "idiophone/foundation/spectra/transform.hpp"

namespace idiophone::propagation {

namespace {

using std::numbers::pi;

constexpr std::size_t late_direction_count = 12;

double octave_centre(std::size_t band) {
  return scene::lowest_octave * std::exp2(static_cast<double>(band));
}

/// The walls' band for one of the late field, which has more.
std::size_t wall_band(std::size_t band) {
  return std::min(band, scene::OctaveBands().size() - 1);
}

/// Absorption of energy by the air, 1/m.
LateBands air_absorption(const scene::AirProperties& air) {
  LateBands bands{};
  for (std::size_t band = 0; air.absorption && band < bands.size(); ++band) {
    const radiation::Atmosphere atmosphere{air.temperature, air.humidity, air.pressure};
    bands.at(band) = 2.0 * atmosphere.attenuation(octave_centre(band));
  }
  return bands;
}

/// A spiral of points from pole to pole with equal areas between its turns.
Vector3 direction_of(std::size_t number) {
  const double height = 1.0 - (2.0 * static_cast<double>(number) + 1.0) / late_direction_count;
  const double angle = static_cast<double>(number) * pi * (3.0 - std::sqrt(5.0));
  const double radius = std::sqrt(1.0 - height * height);
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

/// Amplitude factor of a band at a frequency. The squares over all bands add up to one.
double band_gain(std::size_t band, double frequency) {
  const double octave = frequency > scene::lowest_octave ? std::log2(frequency / scene::lowest_octave) : 0.0;
  const double distance = std::min(octave, LateBands().size() - 1.0) - static_cast<double>(band);
  return std::abs(distance) < 1.0 ? std::cos(0.5 * pi * distance) : 0.0;
}

/// Noise of a band with a mean power of its share of the spectrum: all of it would have 1.
std::vector<double> band_noise(std::size_t band, std::size_t size, int rate, std::mt19937_64& engine) {
  std::vector<std::complex<double>> spectrum(size / 2 + 1);
  for (std::size_t k = 1; k < spectrum.size(); ++k) {
    const double phase = 2.0 * pi * uniform(engine);
    const double frequency = static_cast<double>(k) * rate / static_cast<double>(size);
    spectrum[k] = std::polar(band_gain(band, frequency) / std::sqrt(static_cast<double>(size)), phase);
  }
  return spectra::inverse_transform(std::move(spectrum), size);
}

}  // namespace

std::vector<LateDirection> late_directions(const scene::Radiation& radiation) {
  const scene::Room& room = radiation.room.value();
  const LateBands air = air_absorption(radiation.air);
  std::vector<LateDirection> all;
  for (std::size_t number = 0; number < late_direction_count; ++number) {
    LateDirection& late = all.emplace_back(direction_of(number));
    const Vector3 reflections = late.direction.cwiseAbs().cwiseQuotient(room.size);  // in a metre
    late.distance = (room.order() + 0.5) / reflections.sum();
    late.paths =
        4.0 * pi * late.distance * late.distance * radiation.air.speed / (late_direction_count * room.volume());
    for (std::size_t band = 0; band < late.remaining.size(); ++band) {
      double loss = air.at(band);                                      // in a metre
      for (std::size_t wall = 0; wall < scene::Room::walls; ++wall) {  // half of the reflections of an axis at each
        loss += 0.5 * reflections[static_cast<Eigen::Index>(wall / 2)] * room.loss(wall, wall_band(band));
      }
      late.remaining.at(band) = std::exp(-loss * late.distance);
    }
  }
  return all;
}

LateBands late_decay(const scene::Radiation& radiation) {
  LateBands decay = air_absorption(radiation.air);
  for (std::size_t band = 0; band < decay.size(); ++band) {
    decay.at(band) =
        radiation.air.speed * decay.at(band) + radiation.room.value().decay_rate(wall_band(band), radiation.air.speed);
  }
  return decay;
}

std::vector<double> late_tail(const LateDirection& direction, const LateBands& decay, int rate, std::uint64_t seed) {
  const double seconds = 6.0 * std::log(10.0) / *std::ranges::min_element(decay);
  const auto taps = static_cast<std::size_t>(std::ceil(seconds * rate));
  std::mt19937_64 engine(seed);
  std::vector<double> tail(taps);
  for (std::size_t band = 0; band < decay.size(); ++band) {
    const std::vector<double> noise = band_noise(band, std::bit_ceil(taps), rate, engine);
    const double first = std::sqrt(direction.paths * direction.remaining.at(band) / rate);
    const double fall = 0.5 * decay.at(band) / rate;
    for (std::size_t n = 0; n < taps; ++n) {
      tail[n] += first * noise[n] * std::exp(-fall * static_cast<double>(n));
    }
  }
  return tail;
}

}  // namespace idiophone::propagation
