#include "hinge.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/place_text.hpp"

namespace idiophone::motion {

namespace {

constexpr double straightness = 1e-6;  ///< of the hinge's length

}  // namespace

void require_straight(const scene::FixedGroup& hinge, std::span<const Index> nodes,
                      const std::vector<Vector3>& positions) {
  if (nodes.size() < 2) {
    throw deck::DeckError(
        hinge.where, fmt::format("the hinge '{}' has {} node{}; it needs 2 or more on a straight line", hinge.group,
                                 nodes.size(), nodes.size() == 1 ? "" : "s"));
  }
  const auto position = [&](Index node) { return positions[node]; };
  /// The node with the largest of some distance.
  const auto farthest = [&](const auto& distance) {
    return position(*std::ranges::max_element(nodes, {}, [&](Index node) { return distance(position(node)); }));
  };
  // From any point of a straight line, the farthest one is an end, and from there, the other end.
  const Vector3 any = position(nodes.front());
  const Vector3 begin = farthest([&](const Vector3& x) { return (x - any).norm(); });
  const Vector3 end = farthest([&](const Vector3& x) { return (x - begin).norm(); });
  const Eigen::ParametrizedLine<double, 3> line(begin, (end - begin).normalized());
  const auto off = [&](const Vector3& x) { return line.distance(x); };
  const Vector3 worst = farthest(off);
  if (off(worst) > straightness * (end - begin).norm()) {
    throw deck::DeckError(
        hinge.where,
        fmt::format("the hinge '{}' is not straight: its node at {} is {:.4g} m off the line from {} to {}; name a "
                    "straight edge by Physical Curve(\"{}\") in gmsh",
                    hinge.group, to_text(worst), off(worst), to_text(begin), to_text(end), hinge.group));
  }
}

}  // namespace idiophone::motion
