#include "idiophone/air/surface/equivalent_radius.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "facing_columns.hpp"
#include "facing_tree.hpp"

namespace idiophone::surface {

namespace {

constexpr double share = 3.0 * std::numbers::sqrt2 / (8.0 * std::numbers::pi);  // 3/sqrt 2 of 1/(4 pi)

/// @param sum_over_others  as FacingColumns::sum() of all triangles
template <class Sum>
std::vector<double> radii_of(std::span<const std::array<Vector3, 3>> surface, std::span<const Index> which,
                             const Sum& sum_over_others) {
  std::vector<double> radii;
  for (const Index number : which) {
    const FlatPiece piece = flat_piece(surface[number]);
    // Of the triangle itself the integral of 1/distance is that of a disc of its area, from the disc's centre.
    const double itself = 2.0 * std::sqrt(std::numbers::pi * piece.area.norm());
    radii.push_back(share * (sum_over_others(piece) + itself));
  }
  return radii;
}

}  // namespace

std::vector<double> equivalent_radii(std::span<const std::array<Vector3, 3>> surface, std::span<const Index> which) {
  if (surface.size() > most_summed_directly) {
    const FacingTree tree(surface);
    return radii_of(surface, which, [&](const FlatPiece& piece) { return tree.sum(piece); });
  }
  const FacingColumns columns = columns_of(surface);
  return radii_of(surface, which, [&](const FlatPiece& piece) { return columns.sum(piece, 0, columns.fours()); });
}

}  // namespace idiophone::surface
