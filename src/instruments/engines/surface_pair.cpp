#include "surface_pair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace idiophone::engines {

namespace {

constexpr double longest_contact = 0.1;  // s

void require(bool good, std::size_t number, const char* what) {
  if (!good) {
    throw std::runtime_error(fmt::format("surface {}: {}", number, what));
  }
}

}  // namespace

void check_surface(const Surface& surface, std::size_t number) {
  const auto between = [](double value, double least, double most) { return value >= least && value <= most; };
  require(between(surface.young, 1e3, 1e13), number, "Young's modulus has to be from 1e3 to 1e13 Pa");
  require(between(surface.poisson, -0.99, 0.5), number, "Poisson's ratio has to be from -0.99 to 0.5");
  require(between(surface.radius, 1e-6, 1e3), number, "the radius has to be from 1e-6 to 1e3 m");
  require(between(surface.height, 0.0, 0.1), number, "the height of the roughness has to be from 0 to 0.1 m");
  require(between(surface.exponent, 0.0, 10.0), number, "the exponent of the roughness has to be from 0 to 10");
  require(between(surface.shortest, 1e-7, 1.0) && between(surface.longest, surface.shortest, 10.0), number,
          "wavelengths of the roughness have to be from 1e-7 to 10 m, the longest at least as long as the shortest");
  require(between(surface.friction, 0.0, 10.0), number, "the friction has to be from 0 to 10");
}

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

}  // namespace idiophone::engines
