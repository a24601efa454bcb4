#include "surface_pieces.hpp"

#include <array>

#include "sub_voxels.hpp"

namespace idiophone::waves {

namespace {

/// Distances in front of a surface where its air is sought, in sub-voxels; a cell's surface is known to one of them.
constexpr std::array in_front = {0.5, 1.0, 1.5, 2.0, 2.5, 0.0};

}  // namespace

Index node_in_front(const CutCells& cut_cells, const SurfacePiece& piece) {
  for (const double distance : in_front) {
    const Index node = cut_cells.node_at(piece.centre + distance / voxels * piece.normal);
    if (node >= 0) {
      return node;
    }
  }
  return -1;
}

}  // namespace idiophone::waves
