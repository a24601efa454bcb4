#include "surface_pair.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::touching {

namespace {

constexpr double longest_contact = 0.1;  // s

}  // namespace

double hardness_of(const Surface& first, const Surface& second) {
  const auto compliance = [](const Surface& side) { return (1.0 - side.poisson * side.poisson) / side.young; };
  return 4.0 / 3.0 / (compliance(first) + compliance(second)) / std::sqrt(1.0 / first.radius + 1.0 / second.radius);
}

score::Hammer impact_of(double impulse, double mass, const Surface& first, const Surface& second) {
  score::Hammer hammer{.mass = mass, .hardness = hardness_of(first, second), .speed = impulse / (2.0 * mass)};
  const double excess = std::max(1.0, hammer.contact_duration() / longest_contact);
  hammer.hardness *= std::pow(excess, 2.5);  // the duration falls as hardness^(-2/5)
  return hammer;
}

score::Stroke stroke_of(score::Stroke::Kind kind, double mass, const Surface& first, const Surface& second) {
  const Surface& rougher = first.height > second.height ? first : second;
  score::Stroke stroke;
  stroke.kind = kind;
  stroke.to = Vector3::UnitX();  // RunningStroke goes to and fro; the stage says where
  stroke.mass = mass;
  stroke.hardness = hardness_of(first, second);
  stroke.roughness = {.height = std::hypot(first.height, second.height),
                      .exponent = rougher.exponent,
                      .longest = rougher.longest,
                      .shortest = rougher.shortest};
  return stroke;
}

}  // namespace idiophone::touching
