#pragma once
// The air near surfaces: cells that surfaces cut, and the open area between them and their neighbours.

#include <array>
#include <cstdint>
#include <vector>

#include "idiophone/air/waves/grid.hpp"
#include "idiophone/air/waves/obstruction.hpp"

namespace idiophone::waves {

/// The least volume of a node over the sum of its open areas, both over those of a cell, with which steps are stable:
/// the eigenvalues of leapfrog stay below 4 if C^2/V sum A is at most 2 in each row, and a little is left for rounding.
/// @param courant  C = c dt/h
[[nodiscard]] constexpr double least_volume(double courant) {
  return 1.026 * courant * courant / 2.0;
}

/// One connected part of the air in a cell, with a pressure of its own: the two sides of a thin sheet are two nodes of
/// one cell.
struct Node {
  std::array<int, 3> cell{};
  std::array<std::uint64_t, 8> mask{};  ///< its sub-voxels, see sub_voxels.hpp
  float volume = 0.0F;                  ///< over the volume of a cell; at least least_volume() times the open areas
};

/// An opening between a node and its neighbour.
struct Link {
  Index to = 0;       ///< place in the field's array of pressures
  float area = 0.0F;  ///< over the area of a face; less than is open where the air flows around an edge in a cell
};

/// The walls that a node is in front of, for what they take from the sound.
struct WallShare {
  float area = 0.0F;                ///< over the area of a face
  std::array<float, 3> friction{};  ///< along each axis: area that the air along it rubs on, over the open area of the
                                    ///< node's two faces across it
};

/// Cells of solids, which have no pressure: a piece of a row.
struct SolidRun {
  Index first = 0;  ///< number of a cell in arrays of the slab
  Index length = 0;
};

/// The nodes of a slab and of the planes next to it, in the order of their cells. All other cells have no surface near
/// them. The same surfaces give the same nodes on any rank.
class CutCells {
 public:
  /// No surfaces.
  explicit CutCells(const Slab& slab);
  /// @param courant     c dt/h of the steps
  /// @param with_walls  whether walls() are wanted; all neighbours of cut cells are nodes then
  CutCells(const Slab& slab, const Obstruction& obstruction, double courant, bool with_walls = false);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// Nodes of the planes from slab.begin() - 1 to slab.end(): [planes + 1] where they begin.
  [[nodiscard]] Index first_node(int z) const { return first_of_plane_[z - slab_.begin() + 1]; }

  /// The openings of a node of the slab's own planes; none of others.
  [[nodiscard]] std::pair<Index, Index> links_of(Index node) const {
    return {first_link_[node], first_link_[node + 1]};
  }
  [[nodiscard]] const std::vector<Link>& links() const { return links_; }

  /// [nodes] 0 for those of other planes; empty if they were not wanted.
  [[nodiscard]] const std::vector<WallShare>& walls() const { return walls_; }

  [[nodiscard]] const std::vector<SolidRun>& solids() const { return solids_; }

  /// The nodes of a cell from the first one to before the last; the same number twice where it has none.
  [[nodiscard]] std::pair<Index, Index> nodes_of(const std::array<int, 3>& cell) const;
  [[nodiscard]] bool is_solid(const std::array<int, 3>& cell) const;

  /// The node at a point, and -1 where the point is in open air, in a solid, or outside the slab and its neighbours.
  [[nodiscard]] Index node_at(const Vector3& in_cells) const;

 private:
  Slab slab_;
  std::vector<Node> nodes_;
  std::vector<Index> first_of_plane_;
  std::vector<Index> first_link_;
  std::vector<Link> links_;
  std::vector<WallShare> walls_;
  std::vector<SolidRun> solids_;
  // A box of cells around the surfaces: the first node, or what the cell is.
  std::array<int, 3> from_{}, to_{};
  std::vector<Index> contents_;

  class Builder;
  [[nodiscard]] Index content(const std::array<int, 3>& cell) const;
};

}  // namespace idiophone::waves
