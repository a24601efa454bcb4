#pragma once
// The cells that closed surfaces fill or cut.

#include <vector>

#include "idiophone/air/waves/grid.hpp"
#include "idiophone/air/waves/obstruction.hpp"
#include "sub_voxels.hpp"

namespace idiophone::waves {

/// A box of cells: from `from` to before `to` along each axis.
struct CellBox {
  std::array<int, 3> from{}, to{};

  [[nodiscard]] bool contains(const std::array<int, 3>& cell) const {
    return cell[0] >= from[0] && cell[0] < to[0] && cell[1] >= from[1] && cell[1] < to[1] && cell[2] >= from[2] &&
           cell[2] < to[2];
  }
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(to[0] - from[0]) * (to[1] - from[1]) * (to[2] - from[2]);
  }
  [[nodiscard]] std::size_t place(const std::array<int, 3>& cell) const {
    return (static_cast<std::size_t>(cell[2] - from[2]) * (to[1] - from[1]) + (cell[1] - from[1])) * (to[0] - from[0]) +
           (cell[0] - from[0]);
  }
};

/// A sub-voxel is solid if the surfaces wind about its centre.
class SolidVoxels {
 public:
  /// What is in a cell; a number from 0 on is that of its mask.
  enum Content : Index { air = -1, solid = -2 };

  /// Of two planes more than the slab has, on both sides.
  SolidVoxels(const Slab& slab, const Obstruction& obstruction);

  /// Two cells of air surround the surfaces in it, unless the slab ends there.
  [[nodiscard]] const CellBox& box() const { return box_; }
  /// Air outside the box.
  [[nodiscard]] Index content(const std::array<int, 3>& cell) const {
    return box_.contains(cell) ? contents_[box_.place(cell)] : Index{air};
  }
  /// The solid part of each cell that is cut.
  [[nodiscard]] const std::vector<Mask>& masks() const { return masks_; }

 private:
  /// Where a line along x passes through a surface.
  struct Crossing {
    Index line;     ///< within a plane of cells
    float x;        ///< from the grid's corner, in sub-voxels
    int direction;  ///< 1: into the solid, -1: out of it
  };
  void find_box(const Slab& slab, const Obstruction& obstruction);
  void cross(const std::array<Vector3, 3>& triangle);
  void fill_plane(int z, std::vector<Mask>& plane);
  void fill_line(Index line, double from, double to, std::vector<Mask>& plane) const;

  CellBox box_;
  std::vector<std::vector<Crossing>> crossings_;  // [planes of the box]
  std::vector<Index> contents_;
  std::vector<Mask> masks_;
};

}  // namespace idiophone::waves
