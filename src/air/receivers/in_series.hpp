#pragma once
// Filters one after the other.

#include <vector>

namespace idiophone::receivers {

/// The response of two filters in series: their convolution.
[[nodiscard]] inline std::vector<double> in_series(const std::vector<double>& first,
                                                   const std::vector<double>& second) {
  std::vector<double> both(first.size() + second.size() - 1);
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t k = 0; first[i] != 0.0 && k < second.size(); ++k) {
      both[i + k] += first[i] * second[k];
    }
  }
  return both;
}

}  // namespace idiophone::receivers
