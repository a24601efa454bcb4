#include "idiophone/solids/solid/relaxation.hpp"

#include <cmath>
#include <numbers>

#include "pole_zero_chain.hpp"

namespace idiophone::solid {

double Relaxation::instantaneous() const {
  double sum = long_term;
  for (const Mechanism& mechanism : mechanisms) {
    sum += mechanism.strength;
  }
  return sum;
}

double Relaxation::instantaneous_damping() const {
  double sum = 0.0;
  for (const Mechanism& mechanism : mechanisms) {
    sum += mechanism.strength * mechanism.rate;
  }
  return sum / instantaneous();
}

std::complex<double> Relaxation::modulus(double frequency) const {
  const std::complex<double> s(0.0, frequency);
  std::complex<double> sum = long_term;
  for (const Mechanism& mechanism : mechanisms) {
    sum += mechanism.strength * s / (s + mechanism.rate);
  }
  return sum;
}

Relaxation fit_relaxation(const scene::LossFactor& loss) {
  const PoleZeroChain chain = fitted_chain(loss);
  const std::size_t count = chain.centres.size();
  const auto zero = [&](std::size_t i) { return std::exp(chain.centres[i] - chain.strengths[i]); };
  const auto pole = [&](std::size_t i) { return std::exp(chain.centres[i] + chain.strengths[i]); };
  Relaxation relaxation{.mechanisms = {}, .deviation = chain.deviation};  // K = 1 at first
  for (std::size_t i = 0; i < count; ++i) {
    relaxation.long_term *= zero(i) / pole(i);
    double strength = -std::expm1(-2 * chain.strengths[i]);  // 1 - z_i/p_i
    for (std::size_t j = 0; j < count; ++j) {
      strength *= j == i ? 1.0 : (zero(j) - pole(i)) / (pole(j) - pole(i));
    }
    relaxation.mechanisms.push_back({strength, pole(i)});
  }
  const double low = std::log(2 * std::numbers::pi * loss.band[0]);
  const double high = std::log(2 * std::numbers::pi * loss.band[1]);
  const double storage = relaxation.modulus(std::exp(low + 0.5 * (high - low))).real();
  relaxation.long_term /= storage;
  for (Relaxation::Mechanism& mechanism : relaxation.mechanisms) {
    mechanism.strength /= storage;
  }
  return relaxation;
}

Relaxation creeping(const Relaxation& relaxation, double rate) {
  // Of the product of each mechanism with s/(s + rate), by partial fractions.
  Relaxation creeping{.long_term = 0.0, .mechanisms = {}};
  double strength = relaxation.long_term;
  for (const auto& [own_strength, own_rate] : relaxation.mechanisms) {
    creeping.mechanisms.push_back({own_strength * own_rate / (own_rate - rate), own_rate});
    strength -= own_strength * rate / (own_rate - rate);
  }
  creeping.mechanisms.push_back({strength, rate});
  return creeping;
}

}  // namespace idiophone::solid
