#pragma once
// Four triangles' corners, read from rows x y z of their vertices and combined.

#include <array>
#include <vector>

#include "idiophone/foundation/lanes.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::surface {

/// What is needed of a vector field at the corners 1, 2, 3.
struct Corners {
  VectorLanes sum;     ///< 1 + 2 + 3
  VectorLanes edge12;  ///< 2 - 1
  VectorLanes edge13;  ///< 3 - 1
};

/// Where the corners of each four triangles begin in rows x y z of their vertices: [3 corners][4 lanes] for each four.
/// Triangles added as padding have all corners at vertex 0.
inline std::vector<Index> corner_places(const std::vector<std::array<Index, 3>>& triangles) {
  std::vector<Index> places(3 * padded(triangles.size()));
  for (std::size_t number = 0; number < triangles.size(); ++number) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      places[3 * (number - number % lane_count) + corner * lane_count + number % lane_count] =
          3 * triangles[number][corner];
    }
  }
  return places;
}

/// @param places  [3 corners][4 triangles] places of the corners' x in `rows`; one value past z has to be readable
inline Corners gather(const Index* places, const double* rows) {
  std::array<Lanes4, lane_count> sums, edges12, edges13;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const Lanes4 corner1 = load(rows + places[lane]);
    const Lanes4 corner2 = load(rows + places[lane_count + lane]);
    const Lanes4 corner3 = load(rows + places[2 * lane_count + lane]);
    sums[lane] = corner1 + corner2 + corner3;
    edges12[lane] = corner2 - corner1;
    edges13[lane] = corner3 - corner1;
  }
  return {columns(sums), columns(edges12), columns(edges13)};
}

inline VectorLanes cross(const VectorLanes& a, const VectorLanes& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Lanes4 dot(const VectorLanes& a, const VectorLanes& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Length, never zero, so that a triangle without area gets a zero normal. NaN stays NaN.
inline Lanes4 divisible_length(const VectorLanes& vector) {
  const Lanes4 square = dot(vector, vector);
  const Lanes4 smallest = Lanes4{} + 1e-200;
  return square_root(square < smallest ? smallest : square);
}

}  // namespace idiophone::surface
