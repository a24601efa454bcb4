#pragma once
// The edge of a thin sheet in a cell: the air on its two sides is one part, and yet the sheet lies between them.

#include <optional>

#include "sub_voxels.hpp"

namespace idiophone::waves {

/// The air of a part on both sides of a sheet that ends in the cell.
struct DividedPart {
  Mask above{}, below{};
  float opening = 0.0F;  ///< between the two, over the area of a face
};

/// Divides a part of a cell along the sheet that ends in it. The opening is the one with which the sheet acts as if it
/// ended at its geometric edge: one node on both sides would end it up to half a cell too early.
/// @return  none if no sheet ends in the cell, or if it covers little of it
[[nodiscard]] std::optional<DividedPart> divide_at_edge(const Mask& part, const Mask& solid);

}  // namespace idiophone::waves
