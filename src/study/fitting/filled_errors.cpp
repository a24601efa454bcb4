#include "filled_errors.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::fitting {

std::vector<double> filled_errors(std::vector<double> errors) {
  double largest = 0.0;
  for (auto error = errors.begin(); error != errors.end(); ++error) {
    if (!std::isnan(*error)) {
      largest = std::max(largest, *error);
      continue;
    }
    const auto next = std::find_if(error, errors.end(), [](double other) { return !std::isnan(other); });
    if (next == errors.end()) {
      break;
    }
    *error = std::max(largest, *next);
  }
  return errors;
}

}  // namespace idiophone::fitting
