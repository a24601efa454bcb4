#include "sub_voxels.hpp"

namespace idiophone::waves {

namespace {

constexpr std::uint64_t first_column = 0x0101010101010101;  // x = 0 for each y

/// The eight bits of x = 0, one for each y, as the lowest byte.
std::uint64_t gather_column(std::uint64_t layer) {
  return ((layer & first_column) * 0x0102040810204080U) >> 56U;
}

}  // namespace

Mask layers_along(const Mask& mask, std::size_t axis) {
  if (axis == 2) {
    return mask;
  }
  Mask layers{};
  for (int k = 0; k < voxels; ++k) {
    for (int z = 0; z < voxels; ++z) {
      const std::uint64_t byte = axis == 1 ? mask[z] >> (voxels * k) & 0xffU : gather_column(mask[z] >> k);
      layers[k] |= byte << (voxels * z);
    }
  }
  return layers;
}

Mask mask_of_layers(const Mask& layers, std::size_t axis) {
  const Mask turned = layers_along(layers, axis);  // exchanges y and z, or turns x, y, z by one
  return axis == 0 ? layers_along(turned, axis) : turned;
}

Mask connected(const Mask& seed, const Mask& allowed) {
  Mask found = seed;
  bool grows = true;
  while (grows) {
    grows = false;
    for (int z = 0; z < voxels; ++z) {
      const std::uint64_t here = found[z];
      std::uint64_t grown =
          here | here << 8U | here >> 8U | (here << 1U & ~first_column) | (here >> 1U & ~(first_column << 7U));
      grown |= (z > 0 ? found[z - 1] : 0) | (z + 1 < voxels ? found[z + 1] : 0);
      grown &= allowed[z];
      grows = grows || grown != here;
      found[z] = grown;
    }
  }
  return found;
}

Mask first_voxel(const Mask& mask) {
  Mask one{};
  for (int z = 0; z < voxels; ++z) {
    if (mask[z] != 0) {
      one[z] = mask[z] & (~mask[z] + 1);
      break;
    }
  }
  return one;
}

}  // namespace idiophone::waves
