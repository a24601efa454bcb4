#include "idiophone/timbre/nodes/limp_wall.hpp"

#include <cmath>
#include <numbers>

namespace idiophone::timbre {

double LimpWall::corner(double surface_density, double cosine, double impedance) {
  return impedance / (std::numbers::pi * surface_density * cosine);
}

void LimpWall::tune(double corner) {
  pole_ = std::exp(-2.0 * std::numbers::pi * corner);
  const double highest = (1.0 + pole_) / std::hypot(1.0, 0.5 / corner);  // times the response at half the rate
  now_ = 0.5 * (1.0 - pole_ + highest);
  before_ = 0.5 * (1.0 - pole_ - highest);
}

}  // namespace idiophone::timbre
