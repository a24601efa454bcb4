#pragma once
// Lists of numbers, one after the other in one piece of memory.

#include <numeric>
#include <span>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::mesh {

class CompressedRows {
 public:
  /// @param for_each  calls its argument with (row, number) for everything that is listed; numbers stay in this order.
  ///                  It is called twice.
  template <class ForEach>
  CompressedRows(Index rows, const ForEach& for_each) : begins_(rows + 1) {
    for_each([&](Index row, Index) { ++begins_[row + 1]; });
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    numbers_.resize(begins_.back());
    std::vector<std::size_t> next = begins_;
    for_each([&](Index row, Index number) { numbers_[next[row]++] = number; });
  }

  [[nodiscard]] std::span<const Index> operator[](Index row) const {
    return std::span(numbers_).subspan(begins_[row], begins_[row + 1] - begins_[row]);
  }

 private:
  std::vector<std::size_t> begins_;  ///< [rows + 1]
  std::vector<Index> numbers_;
};

}  // namespace idiophone::mesh
