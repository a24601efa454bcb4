#pragma once
// An order in which terms of stretching and pairs of modes that belong together are neighbours. Many terms have few
// pairs, because the body is symmetric. So whole blocks of terms and pairs are zero, and cost nothing.

#include <cstddef>
#include <span>
#include <vector>

#include "idiophone/foundation/stretching/stretching_energy.hpp"

namespace idiophone::stretching {

struct StretchingOrder {
  std::vector<std::size_t> terms;
  std::vector<ModePair> pairs;  ///< those that any term has
};

/// Terms and pairs that are computed at once.
struct BlockSize {
  std::size_t terms, pairs;
};

/// @param quadratic  as of StretchingEnergy
[[nodiscard]] StretchingOrder stretching_order(std::span<const double> quadratic, std::size_t terms, std::size_t modes,
                                               const BlockSize& block);

}  // namespace idiophone::stretching
