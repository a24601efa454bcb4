// Scraping and rolling: a tool on a rough surface.

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <random>

#include "contact_spring.hpp"
#include "idiophone/foundation/random_numbers.hpp"
#include "idiophone/instruments/resonators/force.hpp"
#include "idiophone/instruments/resonators/resonator_bank.hpp"

namespace idiophone::resonators {

namespace {

constexpr double ramp = 0.01;  // s

/// Amplitudes of the force's waves, number n of which has n periods over the stroke: [samples/2 + 1] N.
std::vector<Complex> waves(const score::Stroke& stroke, std::uint64_t seed, std::size_t samples, int rate) {
  const score::Roughness& rough = stroke.roughness;
  const ContactSpring contact(stroke, stroke.load);
  const double lowest = static_cast<double>(rate) / static_cast<double>(samples);  // Hz
  std::mt19937_64 random(seed);
  std::vector<Complex> spectrum(samples / 2 + 1);
  double power = 0.0;
  for (std::size_t n = 1; n <= static_cast<std::size_t>(stroke.speed / (rough.shortest * lowest)); ++n) {
    const double frequency = static_cast<double>(n) * lowest;
    if (stroke.speed < frequency * rough.shortest || stroke.speed > frequency * rough.longest) {
      continue;
    }
    const double height_power = std::pow(static_cast<double>(n), -rough.exponent);
    power += 0.5 * height_power;
    const double phase = 2.0 * std::numbers::pi * uniform(random);
    if (2 * n < samples) {
      const double angular = 2.0 * std::numbers::pi * frequency;
      spectrum[n] =
          0.5 * std::sqrt(height_power) * std::polar(1.0, phase) * contact.force(angular, angular / stroke.speed);
    }
  }
  for (Complex& wave : spectrum) {
    wave *= power > 0.0 ? rough.height / std::sqrt(power) : 0.0;
  }
  return spectrum;
}

/// @param spectrum  is lost
std::vector<double> sum_of_waves(std::vector<Complex> spectrum, std::size_t samples) {
  std::vector<double> sum(samples);
  const std::unique_ptr<fftw_plan_s, void (*)(fftw_plan)> plan(
      fftw_plan_dft_c2r_1d(static_cast<int>(samples), reinterpret_cast<fftw_complex*>(spectrum.data()), sum.data(),
                           FFTW_ESTIMATE),
      &fftw_destroy_plan);
  fftw_execute(plan.get());
  return sum;
}

}  // namespace

std::vector<double> stroke_force(const score::Stroke& stroke, std::uint64_t seed, int rate) {
  const double duration = (stroke.to - stroke.from).norm() / stroke.speed;
  const auto samples = std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(duration * rate)));
  std::vector<double> force = sum_of_waves(waves(stroke, seed, samples, rate), samples);
  const double rise = std::min(ramp, 0.5 * duration) * rate;
  for (std::size_t i = 0; i < samples; ++i) {
    const double to_end = std::min(static_cast<double>(i), static_cast<double>(samples - 1 - i));
    const double share = to_end < rise ? 0.5 - 0.5 * std::cos(std::numbers::pi * to_end / rise) : 1.0;
    force[i] = share * std::max(0.0, stroke.load + force[i]);
  }
  return force;
}

}  // namespace idiophone::resonators
