#include "idiophone/scene/bowing.hpp"

#include <algorithm>

namespace idiophone::scene {

double Bowing::load_at(double time) const {
  constexpr double ramp = 0.01;  // s
  const double share = std::clamp(std::min(time, duration - time) / ramp, 0.0, 1.0);
  return share * load.at(time);
}

}  // namespace idiophone::scene
