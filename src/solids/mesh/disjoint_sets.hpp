#pragma once
// Which of some numbers belong together.

#include <numeric>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::mesh {

/// Union-find, halving the paths.
class DisjointSets {
 public:
  /// The numbers below `size`, each by itself.
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// The number that stands for all that belong together with this one.
  [[nodiscard]] Index root(Index number) {
    while (parent_[number] != number) {
      Index& up = parent_[number];
      up = parent_[up];
      number = up;
    }
    return number;
  }

  void join(Index a, Index b) { parent_[root(a)] = root(b); }

 private:
  std::vector<Index> parent_;
};

}  // namespace idiophone::mesh
