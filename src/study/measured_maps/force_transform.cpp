#include "force_transform.hpp"

#include <cmath>
#include <numbers>

namespace idiophone::measured_maps {

namespace {

using Complex = std::complex<double>;

/// By the middles of steps that are short against the period and the decay.
template <class Force>
Complex integral(const Force& force, double begin, double end, Complex exponent, int least_steps) {
  const double length = end - begin;
  const int steps = std::max(least_steps, static_cast<int>(std::ceil(20.0 * std::abs(exponent) * length)));
  Complex sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double time = begin + (i + 0.5) * length / steps;
    sum += force(time) * std::exp(-exponent * time) * (length / steps);
  }
  return sum;
}

Complex whole_integral(const RecordedBlow& blow, Complex exponent) {
  if (blow.force.empty()) {
    const double peak = 0.5 * std::numbers::pi * blow.impulse / blow.contact;
    return integral([&](double time) { return peak * std::sin(std::numbers::pi * time / blow.contact); }, 0.0,
                    blow.contact, exponent, 200);
  }
  Complex sum = 0.0;
  for (std::size_t row = 1; row < blow.force.size(); ++row) {
    const auto [begin, from] = blow.force[row - 1];
    const auto [end, to] = blow.force[row];
    const auto line = [&](double time) { return from + (to - from) * (time - begin) / (end - begin); };
    sum += integral(line, begin, end, exponent, 1);
  }
  return sum;
}

}  // namespace

Complex force_transform(const RecordedBlow& blow, Complex exponent) {
  constexpr double least = 0.02;
  if (blow.force.empty() && blow.contact == 0.0) {
    return blow.impulse;
  }
  const Complex transform = whole_integral(blow, exponent);
  const double impulse = std::abs(whole_integral(blow, 0.0));
  const double magnitude = std::abs(transform);
  if (magnitude >= least * impulse) {
    return transform;
  }
  return magnitude > 0.0 ? transform * (least * impulse / magnitude) : Complex(least * impulse);
}

}  // namespace idiophone::measured_maps
