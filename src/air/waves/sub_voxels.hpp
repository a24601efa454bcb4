#pragma once
// Which parts of a cell are air: each cell is divided into 8 x 8 x 8 sub-voxels, one bit each.

#include <array>
#include <bit>
#include <cstdint>

namespace idiophone::waves {

inline constexpr int voxels = 8;  ///< sub-voxels along the edge of a cell

/// 64 bits for each layer of constant z: bit 8 y + x.
using Mask = std::array<std::uint64_t, voxels>;

inline constexpr std::uint64_t all_bits = ~std::uint64_t{0};
inline constexpr Mask full_mask = {all_bits, all_bits, all_bits, all_bits, all_bits, all_bits, all_bits, all_bits};

[[nodiscard]] inline int count(const Mask& mask) {
  int bits = 0;
  for (const std::uint64_t layer : mask) {
    bits += std::popcount(layer);
  }
  return bits;
}

/// How many sub-voxels two masks have in common.
[[nodiscard]] inline int overlap(const Mask& a, const Mask& b) {
  int bits = 0;
  for (int z = 0; z < voxels; ++z) {
    bits += std::popcount(a[z] & b[z]);
  }
  return bits;
}

[[nodiscard]] inline bool contains(const Mask& mask, const std::array<int, 3>& voxel) {
  return (mask[voxel[2]] >> (voxels * voxel[1] + voxel[0]) & 1U) != 0;
}

[[nodiscard]] inline Mask complement(const Mask& mask) {
  Mask rest;
  for (int z = 0; z < voxels; ++z) {
    rest[z] = ~mask[z];
  }
  return rest;
}

/// The layers of a mask along an axis, each with its bits in an order that is the same for every mask.
[[nodiscard]] Mask layers_along(const Mask& mask, std::size_t axis);

/// The reverse of layers_along().
[[nodiscard]] Mask mask_of_layers(const Mask& layers, std::size_t axis);

/// The sub-voxels of `allowed` that are connected, by faces, with the seed.
[[nodiscard]] Mask connected(const Mask& seed, const Mask& allowed);

/// One sub-voxel of a mask that is not empty.
[[nodiscard]] Mask first_voxel(const Mask& mask);

}  // namespace idiophone::waves
