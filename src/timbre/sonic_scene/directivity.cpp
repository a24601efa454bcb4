#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"

namespace idiophone::timbre {

double Directivity::gain(double cosine) const {
  if (levels.empty()) {
    return 1.0 - share + share * cosine;
  }
  const double degrees = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
  const auto next = std::ranges::find_if(levels, [degrees](const auto& row) { return row[0] > degrees; });
  if (next == levels.begin() || next == levels.end()) {
    return std::pow(10.0, (next == levels.end() ? levels.back() : levels.front())[1] / 20.0);
  }
  const auto& [angle, level] = *std::prev(next);
  const double part = (degrees - angle) / ((*next)[0] - angle);
  return std::pow(10.0, (level + part * ((*next)[1] - level)) / 20.0);
}

double Directivity::diffuse_gain() const {
  constexpr int rings = 1000;  // of equal area
  double sum = 0.0;
  for (int ring = 0; ring < rings; ++ring) {
    const double pressure = gain((2.0 * ring + 1.0) / rings - 1.0);
    sum += pressure * pressure;
  }
  return std::sqrt(sum / rings);
}

}  // namespace idiophone::timbre
