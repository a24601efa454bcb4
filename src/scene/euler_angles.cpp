#include "idiophone/scene/euler_angles.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace idiophone::scene {

Eigen::Matrix3d axes_of_euler_angles(const Vector3& degrees) {
  const auto about = [&](int k, const Vector3& axis) {
    return Eigen::AngleAxisd(degrees[k] * std::numbers::pi / 180, axis).toRotationMatrix();
  };
  return about(0, Vector3::UnitZ()) * about(1, Vector3::UnitX()) * about(2, Vector3::UnitZ());
}

Vector3 euler_angles(const Eigen::Matrix3d& axes) {
  constexpr double negligible = 1e-9;  // of a sine: phi1 and phi2 are about one line
  const double sine = std::hypot(axes(0, 2), axes(1, 2));
  Vector3 radians{std::atan2(axes(1, 0), axes(0, 0)), std::atan2(sine, axes(2, 2)), 0};
  if (sine > negligible) {
    radians[0] = std::atan2(axes(0, 2), -axes(1, 2));
    radians[2] = std::atan2(axes(2, 0), axes(2, 1));
  }
  return radians * 180 / std::numbers::pi;
}

}  // namespace idiophone::scene
