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
  int twin = 0;          ///< number of the part on the other side of an edge, among the cell's parts
  float opening = 0.0F;  ///< towards this part, over the area of a face
};

inline constexpr Part open_cell = {.mask = full_mask,
                                   .open = {all_bits, all_bits, all_bits, all_bits, all_bits, all_bits}};

/// All parts of a cell with something solid in it.
[[nodiscard]] std::vector<Part> parts_of(const Mask& solid);

}  // namespace idiophone::waves
