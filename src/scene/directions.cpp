// Directions and turns.

#include <Eigen/Geometry>
#include <numbers>

#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

bool read(const Node& node, Mistakes& mistakes, Vector3& vector, const UnitVector& /*rule*/) {
  Vector3 found = Vector3::Zero();
  if (!read(node, mistakes, found, Range{.at_least = -1e6, .at_most = 1e6})) {
    return false;
  }
  if (found.stableNorm() <= 1e-6) {
    return mistakes.add(node, "is zero; it must be a direction, e.g. [0, 0, -1]");
  }
  vector = found.stableNormalized();
  return true;
}

Node to_node(const Vector3& vector, const UnitVector& /*rule*/) {
  return to_node(vector, Range{});
}

Eigen::Matrix3d Body::turn() const {
  const double angle = rotation.norm();
  return angle > 0 ? Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix() : Eigen::Matrix3d::Identity();
}

bool read_turn(Section& section, Vector3& rotation) {
  Vector3 axis = Vector3::UnitZ();
  double degrees = 0.0;
  const bool has_axis = section.required("axis", axis, unit_vector);
  if (!section.required("degrees", degrees, Range{.at_least = -1e6, .at_most = 1e6}) || !has_axis) {
    return false;
  }
  rotation = degrees * std::numbers::pi / 180.0 * axis;
  return true;
}

bool read(const Node& node, Mistakes& mistakes, Vector3& rotation, const Turn& /*rule*/) {
  Section section(node, mistakes);
  read_turn(section, rotation);
  return section.finish();
}

Node to_node(const Vector3& /*rotation*/, const Turn& /*rule*/) {
  return {};
}

}  // namespace idiophone::scene
