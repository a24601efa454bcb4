#include "link_points.hpp"

#include <Eigen/Geometry>
#include <utility>

namespace idiophone::joints {

std::array<Vector3, 2> across(const Vector3& direction) {
  const Vector3 first = direction.unitOrthogonal();
  return {first, direction.cross(first)};
}

void append_tie(MeshedJoint& link, const Anchors& anchors, const std::vector<double>& first,
                const std::vector<double>& second, const Vector3& line, double length) {
  const auto& [one, other] = anchors;
  const auto [a, b] = across(line);
  const std::vector<double> along_a = one.slopes_along(a), along_b = one.slopes_along(b);
  JointPoint point{.area = 1.0, .distance = length, .first_begin = static_cast<Index>(link.weights.size())};
  for (std::size_t n = 0; n < one.nodes().size(); ++n) {
    link.weights.push_back({one.nodes()[n], first[n], {along_a[n], along_b[n]}});
  }
  point.second_begin = static_cast<Index>(link.weights.size());
  for (std::size_t n = 0; n < other.nodes().size(); ++n) {
    link.weights.push_back({other.nodes()[n], second[n], {0.0, 0.0}});
  }
  point.end = static_cast<Index>(link.weights.size());
  link.points.push_back(point);
}

MeshedJoint resistance_to_turning(const Anchors& anchors, const std::array<Vector3, 2>& directions, std::size_t number,
                                  const scene::HingeTurning& turning) {
  MeshedJoint joint{.joint = number,
                    .resists_turning = true,
                    .normal = turning.stiffness,
                    .damping = turning.damping,
                    .points = {},
                    .weights = {}};
  JointPoint point{.area = 1.0};
  for (const auto& [anchor, direction] :
       {std::pair(&anchors.one, directions[0]), std::pair(&anchors.other, directions[1])}) {
    point.second_begin = point.end;  // of the body before
    const std::vector<double> slopes = anchor->slopes_along(direction);
    for (std::size_t n = 0; n < slopes.size(); ++n) {
      joint.weights.push_back({anchor->nodes()[n], 0.0, {slopes[n], 0.0}});
    }
    point.end = static_cast<Index>(joint.weights.size());
  }
  joint.points.push_back(point);
  return joint;
}

}  // namespace idiophone::joints
