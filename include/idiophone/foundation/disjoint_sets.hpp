#pragma once
// Which of some numbers belong together.

#include <algorithm>
#include <numeric>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone {

/// Union-find, halving the paths.
class DisjointSets {
 public:
  /// The numbers below `size`, each by itself.
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// The smallest number that belongs together with this one.
  [[nodiscard]] Index root(Index number) {
    while (parent_[number] != number) {
      Index& up = parent_[number];
      up = parent_[up];
      number = up;
    }
    return number;
  }

  void join(Index a, Index b) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    parent_[high] = low;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace idiophone
