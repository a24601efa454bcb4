#include "stage_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "idiophone/instruments/touching/vectors.hpp"

namespace idiophone::engines {

using touching::vector_of;

namespace {

constexpr double least_mass = 1e-9;  // kg

bool is_finite(std::span<const double> numbers) {
  return std::ranges::all_of(numbers, [](double number) { return std::abs(number) <= largest_number; });
}

}  // namespace

void require(bool good, const std::string& problem) {
  if (!good) {
    throw std::runtime_error(problem);
  }
}

void require(bool good, const char* problem) {
  if (!good) {
    throw std::runtime_error(problem);
  }
}

StageOptions checked(StageOptions options) {
  require(options.rate >= 8000 && options.rate <= 384000, "the rate has to be from 8000 to 384000 1/s");
  require(options.most_proxies > 0, "at least one proxy may sound");
  require(options.air_density > 0.0 && options.air_density <= 1e4,
          "the density of the air has to be above 0 to 1e4 kg/m3");
  require(options.air_speed >= 1.0 && options.air_speed <= 1e5, "the speed of sound has to be from 1 to 1e5 m/s");
  require(!options.ears.empty() && options.ears.size() <= most_channels, "a stage has 1 to 4 ears");
  require(options.latency >= 0.0 && options.latency <= 1.0, "the latency has to be from 0 to 1 s");
  require(options.budget >= 0.0, "the budget must not be below 0");
  require(options.speed >= least_speed && options.speed <= most_speed,
          "the speed of the machine has to be from 0.001 to 1000");
  return options;
}

const std::vector<SharedMap>& checked(const std::vector<SharedMap>& bodies) {
  require(std::ranges::all_of(bodies, [](const SharedMap& map) { return map != nullptr; }), "a body has no map");
  return bodies;
}

void check_surface(const Surface& surface, std::size_t number) {
  const auto between = [](double value, double least, double most) { return value >= least && value <= most; };
  const auto check = [number](bool good, const char* what) {
    require(good, fmt::format("surface {}: {}", number, what));
  };
  check(between(surface.young, 1e3, 1e13), "Young's modulus has to be from 1e3 to 1e13 Pa");
  check(between(surface.poisson, -0.99, 0.5), "Poisson's ratio has to be from -0.99 to 0.5");
  check(between(surface.radius, 1e-6, 1e3), "the radius has to be from 1e-6 to 1e3 m");
  check(between(surface.height, 0.0, 0.1), "the height of the roughness has to be from 0 to 0.1 m");
  check(between(surface.exponent, 0.0, 10.0), "the exponent of the roughness has to be from 0 to 10");
  check(between(surface.shortest, 1e-7, 1.0) && between(surface.longest, surface.shortest, 10.0),
        "wavelengths of the roughness have to be from 1e-7 to 10 m, the longest at least as long as the shortest");
  check(between(surface.friction, 0.0, 10.0), "the friction has to be from 0 to 10");
}

std::vector<Surface> checked(std::vector<Surface> surfaces) {
  require(!surfaces.empty(), "a stage needs a surface");
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    check_surface(surfaces[i], i);
  }
  return surfaces;
}

void check_tuning(const Tuning& tuning) {
  const auto between = [](double value, double least, double most) { return value >= least && value <= most; };
  require(between(tuning.tension, 1e-4, 1e4) && between(tuning.friction, 0.0, 1e6) && between(tuning.size, 0.01, 100.0),
          "a tuning has a tension from 1e-4 to 1e4, a friction from 0 to 1e6 and a size from 0.01 to 100");
}

std::vector<Vector3> checked(std::span<const Triple> ears) {
  require(std::ranges::all_of(ears, is_finite),
          "an ear is not at a place: its coordinates have to be from -1e6 to 1e6 m");
  std::vector<Vector3> places;
  std::ranges::transform(ears, std::back_inserter(places), vector_of);
  return places;
}

void check_pose(std::size_t body, const Pose& pose, std::size_t bodies) {
  require(body < bodies, fmt::format("there is no body {}", body));
  const double size = std::hypot(std::hypot(pose.turn[0], pose.turn[1], pose.turn[2]), pose.turn[3]);
  require(
      is_finite(pose.position) && size > 1e-3 && size <= largest_number,
      fmt::format("body {} is at no place: its position has to be from -1e6 to 1e6 m, and its turn not zero", body));
}

void check_event(const ContactEvent& event, std::size_t bodies, std::size_t surfaces) {
  const auto [first, second] = event.bodies;
  const auto count = static_cast<std::int32_t>(bodies);
  require(first >= ContactEvent::nobody && first < count && second >= ContactEvent::nobody && second < count &&
              std::max(first, second) >= 0,
          fmt::format("a contact is between bodies {} and {}; the stage has {}", first, second, count));
  require(first != second, fmt::format("a contact is between body {} and itself", first));
  for (const std::int32_t surface : event.surfaces) {
    require(surface >= 0 && static_cast<std::size_t>(surface) < surfaces,
            fmt::format("a contact has surface {}; the stage has {}", surface, surfaces));
  }
  const std::array numbers = {event.impulse, event.roll, event.mass, event.moment};
  require(is_finite(event.point) && is_finite(event.normal) && is_finite(event.slip) && is_finite(numbers),
          "a contact has a number that is not finite or above 1e6");
  require(event.impulse >= 0.0 && event.roll >= 0.0 && event.moment <= 1.0,
          "a contact has an impulse or a speed below 0, or a moment above 1");
  require(event.mass <= 0.0 || event.mass >= least_mass, "a contact moves a mass below 1e-9 kg");
  require(event.impulse == 0.0 || std::abs(vector_of(event.normal).norm() - 1.0) < 1e-3,
          "the normal of a contact is no unit vector");
}

}  // namespace idiophone::engines
