#pragma once
// The air near surfaces: cells that surfaces cut, and the open area between them and their neighbours.

#include <array>
#include <cstdint>
#include <vector>

#include "idiophone/air/waves/obstruction.hpp"
#include "idiophone/air/waves/subdomain.hpp"

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
  Index first = 0;  ///< number of a cell in arrays of the subdomain
  Index length = 0;
};

/// The nodes of a subdomain in the order of their cells, then those of its ghost cells. All other cells have no surface
/// near them. The same surfaces give the same nodes on any rank.
class CutCells {
 public:
  /// No surfaces.
  explicit CutCells(const Subdomain& subdomain);
  /// @param courant     c dt/h of the steps
  /// @param with_walls  whether walls() are wanted; all neighbours of cut cells are nodes then
  CutCells(const Subdomain& subdomain, const Obstruction& obstruction, double courant, bool with_walls = false);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// How many of the nodes are not in ghost cells; they are the first ones.
  [[nodiscard]] Index own_nodes() const { return own_nodes_; }

  /// The openings of a node; none in ghost cells.
  [[nodiscard]] std::pair<Index, Index> links_of(Index node) const {
    return {first_link_[node], first_link_[node + 1]};
  }
  [[nodiscard]] const std::vector<Link>& links() const { return links_; }

  /// [nodes] 0 in ghost cells; empty if they were not wanted.
  [[nodiscard]] const std::vector<WallShare>& walls() const { return walls_; }

  [[nodiscard]] const std::vector<SolidRun>& solids() const { return solids_; }

  /// The nodes of a cell from the first one to before the last; the same number twice where it has none.
  [[nodiscard]] std::pair<Index, Index> nodes_of(const std::array<int, 3>& cell) const;
  [[nodiscard]] bool is_solid(const std::array<int, 3>& cell) const;

  /// The node at a point, and -1 where the point is in open air, in a solid, or outside the subdomain and its ghost
  /// cells.
  [[nodiscard]] Index node_at(const Vector3& in_cells) const;

 private:
  Subdomain subdomain_;
  std::vector<Node> nodes_;
  Index own_nodes_ = 0;
  std::vector<Index> first_link_;
  std::vector<Link> links_;
  std::vector<WallShare> walls_;
  std::vector<SolidRun> solids_;
  CellBox box_;                  // around the surfaces
  std::vector<Index> contents_;  // of these cells: the first node, or what the cell is

  class Builder;
  [[nodiscard]] Index content(const std::array<int, 3>& cell) const;
};

}  // namespace idiophone::waves
