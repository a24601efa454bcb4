#include "wave_spectrum.hpp"

#include <cmath>
#include <numbers>

namespace idiophone::radiation {

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// The response sqrt(d)/(2 pi (t + d) sqrt(t)) at times t = -i d tan(x)^2.
Complex spectrum(double delay, double frequency) {
  constexpr double step = 1e-4;
  Complex sum = 0.0;
  for (double x = 0.5 * step; x < 0.5 * pi; x += step) {
    const double square = std::pow(std::tan(x), 2);
    sum += step * (1.0 + square) * std::exp(-2 * pi * frequency * delay * square) / Complex(1.0, -square);
  }
  return sum / pi * std::sqrt(Complex(0, -1));
}

}  // namespace

std::complex<double> spectrum_of(const Bend& bend, double frequency) {
  Complex product = bend.gain;
  for (const auto& waves : bend.waves) {
    Complex sum = 0.0;
    for (const EdgeWave& wave : waves) {
      sum += wave.gain == 0.0 ? 0.0 : wave.gain * spectrum(wave.delay, frequency);
    }
    product *= waves[0].gain == 0.0 ? 1.0 : sum;  // no edge
  }
  return product;
}

}  // namespace idiophone::radiation
