#include "idiophone/air/harmonic/sphere_rule.hpp"

#include <cmath>
#include <numbers>

namespace idiophone::harmonic {

SphereRule sphere_rule(unsigned rings) {
  SphereRule rule{rings, 2UL * rings, {}, {}};
  for (unsigned ring = 0; ring < rings; ++ring) {
    double z = std::cos(std::numbers::pi * (ring + 0.75) / (rings + 0.5));  // near a root of Legendre's polynomial
    double slope = 0.0;
    for (int newton = 0; newton < 10; ++newton) {
      slope = rings * (std::legendre(rings - 1, z) - z * std::legendre(rings, z)) / (1.0 - z * z);
      z -= std::legendre(rings, z) / slope;
    }
    const double weight = 2.0 / ((1.0 - z * z) * slope * slope) * std::numbers::pi / rings;
    for (std::size_t a = 0; a < rule.azimuths; ++a) {
      const double azimuth = std::numbers::pi * static_cast<double>(a) / rings;
      const double sine = std::sqrt(1.0 - z * z);
      rule.directions.emplace_back(sine * std::cos(azimuth), sine * std::sin(azimuth), z);
      rule.weights.push_back(weight);
    }
  }
  return rule;
}

}  // namespace idiophone::harmonic
