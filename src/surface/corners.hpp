#pragma once
// Four triangles' corners, read from rows x y z of their vertices and combined.

#include <array>

#include "idiophone/lanes.hpp"
#include "idiophone/types.hpp"

namespace idiophone::surface {

/// x, y, z of four vectors.
using VectorLanes = std::array<Lanes, 3>;

/// What is needed of a vector field at the corners 1, 2, 3.
struct Corners {
  VectorLanes sum;     ///< 1 + 2 + 3
  VectorLanes edge12;  ///< 2 - 1
  VectorLanes edge13;  ///< 3 - 1
};

/// @param places  [3 corners][4 triangles] places of the corners' x in `rows`; one value past z has to be readable
inline Corners gather(const Index* places, const double* rows) {
  std::array<Lanes, lane_count> sums, edges12, edges13;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const Lanes corner1 = load(rows + places[lane]);
    const Lanes corner2 = load(rows + places[lane_count + lane]);
    const Lanes corner3 = load(rows + places[2 * lane_count + lane]);
    sums[lane] = corner1 + corner2 + corner3;
    edges12[lane] = corner2 - corner1;
    edges13[lane] = corner3 - corner1;
  }
  return {columns(sums), columns(edges12), columns(edges13)};
}

inline VectorLanes cross(const VectorLanes& a, const VectorLanes& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Lanes dot(const VectorLanes& a, const VectorLanes& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Length, never zero, so that a triangle without area gets a zero normal. NaN stays NaN.
inline Lanes divisible_length(const VectorLanes& vector) {
  const Lanes square = dot(vector, vector);
  const Lanes smallest = Lanes{} + 1e-200;
  return square_root(square < smallest ? smallest : square);
}

}  // namespace idiophone::surface
