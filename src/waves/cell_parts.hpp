#pragma once
// The connected parts of the air in a cell, and their openings.

#include <vector>

#include "sub_voxels.hpp"

namespace idiophone::waves {

inline constexpr int faces = 6;  ///< of a cell: lower and upper end of each axis

/// A connected part of the air in a cell, and its open sub-voxels on each face.
struct Part {
  Mask mask{};
  std::array<std::uint64_t, faces> open{};
};

inline constexpr Part open_cell = {full_mask, {all_bits, all_bits, all_bits, all_bits, all_bits, all_bits}};

/// All parts of a cell with something solid in it.
[[nodiscard]] std::vector<Part> parts_of(const Mask& solid);

}  // namespace idiophone::waves
