#pragma once
// The cells that closed surfaces fill or cut.

#include <vector>

#include "idiophone/air/waves/obstruction.hpp"
#include "idiophone/air/waves/subdomain.hpp"
#include "sub_voxels.hpp"

namespace idiophone::waves {

/// A sub-voxel is solid if the surfaces wind about its centre.
class SolidVoxels {
 public:
  /// What is in a cell; a number from 0 on is that of its mask.
  enum Content : Index { air = -1, solid = -2 };

  /// Of the subdomain and of two cells around it.
  SolidVoxels(const Subdomain& subdomain, const Obstruction& obstruction);

  /// Two cells of air surround the surfaces in it, unless the subdomain ends there.
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
  void find_box(const Subdomain& subdomain, const Obstruction& obstruction);
  void cross(const std::array<Vector3, 3>& triangle);
  void fill_plane(int z, std::vector<Mask>& plane);
  void fill_line(Index line, double from, double to, std::vector<Mask>& plane) const;

  CellBox box_;
  std::vector<std::vector<Crossing>> crossings_;  // [planes of the box]
  std::vector<Index> contents_;
  std::vector<Mask> masks_;
};

}  // namespace idiophone::waves
