#include "idiophone/air/surface/equivalent_radius.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "idiophone/air/surface/corners.hpp"
#include "idiophone/foundation/lanes.hpp"

namespace idiophone::surface {

namespace {

/// Centres and area vectors as columns of four triangles; those added as padding have no area.
struct Columns {
  std::vector<VectorLanes> centre;  // m
  std::vector<VectorLanes> area;    // area times normal, m2

  explicit Columns(std::span<const std::array<Vector3, 3>> surface)
      : centre((surface.size() + lane_count - 1) / lane_count), area(centre.size()) {
    for (std::size_t i = 0; i < surface.size(); ++i) {
      const auto& [a, b, c] = surface[i];
      const Vector3 middle = (a + b + c) / 3.0;
      const Vector3 vector = 0.5 * (b - a).cross(c - a);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        centre[i / lane_count][axis][i % lane_count] = middle[axis];
        area[i / lane_count][axis][i % lane_count] = vector[axis];
      }
    }
  }
};

VectorLanes everywhere(const Vector3& vector) {
  return {Lanes4{} + vector[0], Lanes4{} + vector[1], Lanes4{} + vector[2]};
}

}  // namespace

std::vector<double> equivalent_radii(std::span<const std::array<Vector3, 3>> surface, std::span<const Index> which) {
  constexpr double share = 3.0 * std::numbers::sqrt2 / (8.0 * std::numbers::pi);  // 3/sqrt 2 of 1/(4 pi)
  const Columns columns(surface);
  const Lanes4 nothing{};
  const Lanes4 smallest = nothing + std::numeric_limits<double>::min();
  std::vector<double> radii;
  for (const Index number : which) {
    const auto& [a, b, c] = surface[number];
    const Vector3 vector = 0.5 * (b - a).cross(c - a);
    const VectorLanes centre = everywhere((a + b + c) / 3.0);
    const VectorLanes normal = everywhere(vector.normalized());
    Lanes4 sum{};
    for (std::size_t four = 0; four < columns.centre.size(); ++four) {
      VectorLanes way;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        way[axis] = columns.centre[four][axis] - centre[axis];
      }
      const Lanes4 square = dot(way, way);
      const Lanes4 facing = dot(columns.area[four], normal);
      const Lanes4 term = facing / square_root(square < smallest ? smallest : square);
      sum += ((facing > nothing) & (square > nothing)) ? term : nothing;
    }
    // Of the triangle itself the integral of 1/distance is that of a disc of its area, from the disc's centre.
    const double itself = 2.0 * std::sqrt(std::numbers::pi * vector.norm());
    radii.push_back(share * ((sum[0] + sum[1]) + (sum[2] + sum[3]) + itself));
  }
  return radii;
}

}  // namespace idiophone::surface
