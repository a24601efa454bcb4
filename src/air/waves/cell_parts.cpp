#include "cell_parts.hpp"

#include <algorithm>
#include <bit>

#include "sheet_edge.hpp"

namespace idiophone::waves {

namespace {

Mask reversed(Mask layers) {
  std::ranges::reverse(layers);
  return layers;
}

/// Columns that start in the air of a part, pass through a solid in the nearer half of the cell, and come back to the
/// same part: the air there flows around the edge of a sheet, not through it.
/// @param air, solid  layers, from the face inwards
/// @param centre      whether a solid in the very middle counts
std::uint64_t blocked_columns(const Mask& air, const Mask& solid, bool centre) {
  std::uint64_t blocked = 0, path = air[0];
  for (int start = 1; start < voxels - 1 && path != 0; ++start) {
    std::uint64_t through = path & solid[start];
    for (int end = start + 1; end < voxels && through != 0; ++end) {
      if (start + end < voxels || (centre && start + end == voxels)) {
        blocked |= through & air[end];
      }
      through &= solid[end];
    }
    path &= air[start];
  }
  return blocked;
}

/// The mean place of the sub-voxels along the axis of these layers, in cells.
float mean_place(const Mask& layers) {
  int sum = 0;  // of the layers' middles, in half sub-voxels
  for (int k = 0; k < voxels; ++k) {
    sum += (2 * k + 1) * std::popcount(layers[k]);
  }
  return static_cast<float>(sum) / static_cast<float>(2 * voxels * count(layers));
}

Part make_part(const Mask& mask, const Mask& solid) {
  Part part{.mask = mask, .open = {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Mask air_layers = layers_along(mask, axis);
    part.centre.at(axis) = mean_place(air_layers);
    const Mask solid_layers = layers_along(solid, axis);
    part.open.at(2 * axis) = air_layers.front() & ~blocked_columns(air_layers, solid_layers, true);
    part.open.at(2 * axis + 1) =
        air_layers.back() & ~blocked_columns(reversed(air_layers), reversed(solid_layers), false);
  }
  return part;
}

void add_divided(const DividedPart& divided, const Mask& solid, std::vector<Part>& parts) {
  const auto first = static_cast<int>(parts.size());
  for (const Mask* mask : {&divided.above, &divided.below}) {
    Part& part = parts.emplace_back(make_part(*mask, solid));
    part.twin = mask == &divided.above ? first + 1 : first;
    part.opening = divided.opening;
  }
}

}  // namespace

float way_between(const Part& part, const Part& next, int face) {
  const auto axis = static_cast<std::size_t>(face / 2);
  const float here = part.centre.at(axis), there = next.centre.at(axis);
  return 1.0F + (face % 2 == 1 ? there - here : here - there);
}

std::vector<Part> parts_of(const Mask& solid) {
  std::vector<Part> parts;
  Mask rest = complement(solid);
  while (count(rest) > 0) {
    const Mask mask = connected(first_voxel(rest), rest);
    if (const auto divided = divide_at_edge(mask, solid)) {
      add_divided(*divided, solid, parts);
    } else {
      parts.push_back(make_part(mask, solid));
    }
    for (int z = 0; z < voxels; ++z) {
      rest[z] &= ~mask[z];
    }
  }
  return parts;
}

}  // namespace idiophone::waves
