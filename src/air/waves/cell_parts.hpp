#pragma once
// The connected parts of the air in a cell, and their openings.

#include <vector>

#include "sub_voxels.hpp"

namespace idiophone::waves {

inline constexpr int faces = 6;  ///< of a cell: lower and upper end of each axis

/// A connected part of the air in a cell, and its open sub-voxels on each face. At the edge of a sheet, the air above
/// and the air below the sheet are two parts.
struct Part {
  Mask mask{};
  std::array<std::uint64_t, faces> open{};
  std::array<float, 3> centre = {0.5F, 0.5F, 0.5F};  ///< of its air, from the cell's lower corner, in cells
  int twin = 0;          ///< number of the part on the other side of an edge, among the cell's parts
  float opening = 0.0F;  ///< towards this part, over the area of a face
};

inline constexpr Part open_cell = {.mask = full_mask,
                                   .open = {all_bits, all_bits, all_bits, all_bits, all_bits, all_bits}};

/// The way of the air between two parts in neighbouring cells through the first one's face, over that between the
/// middles of whole cells: above 1 where it flows around an edge of a solid.
[[nodiscard]] float way_between(const Part& part, const Part& next, int face);

/// All parts of a cell with something solid in it.
[[nodiscard]] std::vector<Part> parts_of(const Mask& solid);

}  // namespace idiophone::waves
