#include "places.hpp"

#include <Eigen/Geometry>
#include <array>
#include <memory>

#include "motion_curve.hpp"

namespace idiophone::timbre {

namespace {

/// Columns of a channel of a body, as smooth curves.
template <std::size_t Columns>
std::array<std::shared_ptr<const Curve>, Columns> curves_of(const std::string& channel,
                                                            const std::array<const char*, Columns>& names,
                                                            const deck::Location& where, const MotionChannels& motion) {
  std::array<std::shared_ptr<const Curve>, Columns> curves;
  for (std::size_t c = 0; c < Columns; ++c) {
    curves[c] = curve_of(
        {.channel = channel, .column = names[c], .interpolation = timbre::Interpolation::cubic, .where = where},
        motion);
  }
  return curves;
}

}  // namespace

std::function<Vector3(double)> path_of(const SonicPlace& place, const deck::Location& where,
                                       const MotionChannels& motion) {
  if (place.at) {
    return [at = *place.at](double /*time*/) { return at; };
  }
  if (place.path) {
    return [path = *place.path](double time) { return path.at(time).position; };
  }
  if (place.body.empty()) {
    return {};
  }
  const auto axes = curves_of<3>("motion/" + place.body + "/centre_of_mass", {"x", "y", "z"}, where, motion);
  return [axes](double time) { return Vector3(axes[0]->at(time), axes[1]->at(time), axes[2]->at(time)); };
}

std::function<Eigen::Matrix3d(double)> turn_of(const SonicPlace& place, const deck::Location& where,
                                               const MotionChannels& motion) {
  if (place.body.empty()) {
    return [](double /*time*/) -> Eigen::Matrix3d { return Eigen::Matrix3d::Identity(); };
  }
  const auto parts = curves_of<4>("motion/" + place.body + "/orientation", {"w", "x", "y", "z"}, where, motion);
  return [parts](double time) -> Eigen::Matrix3d {
    return Eigen::Quaterniond(parts[0]->at(time), parts[1]->at(time), parts[2]->at(time), parts[3]->at(time))
        .normalized()
        .toRotationMatrix();
  };
}

}  // namespace idiophone::timbre
