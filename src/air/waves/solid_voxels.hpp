#pragma once
// The cells that closed surfaces fill or cut.

#include <vector>

#include "idiophone/air/waves/obstruction.hpp"
#include "idiophone/air/waves/subdomain.hpp"
#include "inner_pieces.hpp"
#include "sub_voxels.hpp"

namespace idiophone::waves {

/// A sub-voxel is solid if the surfaces wind about its centre. Where a sheet passes between two centres that are
/// neighbours, the sub-voxel in which it does so is solid, too. So sheets of any thickness let no air through.
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
  void find_box(const Subdomain& subdomain, const Obstruction& obstruction);
  void add_piece(const InnerPiece& piece, std::size_t axis);
  void add_run(const std::array<int, 3>& first, int length);
  void fill_plane(int z);

  /// Solid sub-voxels on a line along x, numbered from the corner of the box.
  struct Run {
    std::array<int, 3> first;
    int length;
  };
  CellBox box_;
  std::vector<std::vector<Run>> runs_;  // [planes of cells of the box]
  std::vector<Index> contents_;
  std::vector<Mask> masks_;
};

}  // namespace idiophone::waves
