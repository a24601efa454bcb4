#include "wall_shares.hpp"

#include <bit>

#include "sub_voxels.hpp"
#include "surface_pieces.hpp"

namespace idiophone::waves {

namespace {

/// The part of a wall that the air rubs on when it flows along an axis. Air at a wall flows along it: with v at right
/// angles to the normal n, the sum of part_rubbed(n_i) v_i^2 over the axes is v^2 if n lies in a plane of two axes, and
/// at most 11 % more otherwise. It is 0 for the axis of the normal, along which the wall itself may move.
/// @param normal  component of the normal along the axis
double part_rubbed(double normal) {
  const double square = normal * normal;
  return (1.0 - square) * (1.0 + 2.0 * square);
}

/// Open area of both faces of a node across an axis, over that of one face.
double open_area(const Node& node, std::size_t axis) {
  const Mask layers = layers_along(node.mask, axis);
  return static_cast<double>(std::popcount(layers.front()) + std::popcount(layers.back())) / (voxels * voxels);
}

}  // namespace

std::vector<WallShare> wall_shares(const Subdomain& subdomain, const Obstruction& obstruction,
                                   const CutCells& cut_cells) {
  struct Sums {
    double area = 0.0;
    Vector3 rubbed = Vector3::Zero();
  };
  std::vector<Sums> sums(cut_cells.nodes().size());
  for (std::size_t triangle = 0; triangle < obstruction.triangles.size(); ++triangle) {
    for_each_front(subdomain, obstruction, static_cast<Index>(triangle), cut_cells,
                   [&](Index node, const SurfacePiece& piece) {
                     sums[node].area += piece.area;
                     sums[node].rubbed += piece.area * piece.normal.unaryExpr(&part_rubbed);
                   });
  }
  const double face = subdomain.grid().cell * subdomain.grid().cell;
  std::vector<WallShare> shares(sums.size());
  for (std::size_t node = 0; node < sums.size(); ++node) {
    shares[node].area = static_cast<float>(sums[node].area / face);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double open = open_area(cut_cells.nodes()[node], axis);
      const double rubbed = sums[node].rubbed[static_cast<Index>(axis)] / face;
      shares[node].friction.at(axis) = open > 0.0 ? static_cast<float>(rubbed / open) : 0.0F;
    }
  }
  return shares;
}

}  // namespace idiophone::waves
