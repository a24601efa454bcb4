#include "facing_columns.hpp"

#include <Eigen/Geometry>
#include <limits>

#include "idiophone/air/surface/corners.hpp"

namespace idiophone::surface {

namespace {

VectorLanes everywhere(const Vector3& vector) {
  return {Lanes4{} + vector[0], Lanes4{} + vector[1], Lanes4{} + vector[2]};
}

}  // namespace

FlatPiece flat_piece(const std::array<Vector3, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  return {(a + b + c) / 3.0, 0.5 * (b - a).cross(c - a)};
}

void FacingColumns::put(std::size_t place, const FlatPiece& piece) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    centre_[place / lane_count][axis][place % lane_count] = piece.centre[axis];
    area_[place / lane_count][axis][place % lane_count] = piece.area[axis];
  }
}

double FacingColumns::sum(const FlatPiece& one, std::size_t begin, std::size_t end) const {
  const Lanes4 nothing{};
  const Lanes4 smallest = nothing + std::numeric_limits<double>::min();
  const VectorLanes centre = everywhere(one.centre);
  const VectorLanes normal = everywhere(one.area.normalized());
  Lanes4 sum{};
  for (std::size_t four = begin; four < end; ++four) {
    VectorLanes way;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      way[axis] = centre_[four][axis] - centre[axis];
    }
    const Lanes4 square = dot(way, way);
    const Lanes4 facing = dot(area_[four], normal);
    const Lanes4 term = facing / square_root(square < smallest ? smallest : square);
    sum += ((facing > nothing) & (square > nothing)) ? term : nothing;
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

FacingColumns columns_of(std::span<const std::array<Vector3, 3>> surface) {
  FacingColumns columns(surface.size());
  for (std::size_t number = 0; number < surface.size(); ++number) {
    columns.put(number, flat_piece(surface[number]));
  }
  return columns;
}

}  // namespace idiophone::surface
