#include "turned_material.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone::fitting {

namespace {

constexpr double degree = std::numbers::pi / 180;

}  // namespace

// Each turn is about an axis that the ones before have turned, so the last one stands on the right.
Eigen::Matrix3d TurnedMaterial::turn() const {
  const auto about = [&](int axis) { return Eigen::AngleAxisd(turns[axis] * degree, Vector3::Unit(axis)); };
  return (about(0) * about(1) * about(2)).toRotationMatrix();
}

Vector3 turns_of(const Eigen::Matrix3d& rotation) {
  return Vector3(std::atan2(-rotation(1, 2), rotation(2, 2)), std::asin(std::clamp(rotation(0, 2), -1.0, 1.0)),
                 std::atan2(-rotation(0, 1), rotation(0, 0))) /
         degree;
}

}  // namespace idiophone::fitting
