#include "filled_errors.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::fitting {

std::vector<double> filled_errors(std::vector<double> errors) {
  double below = 0.0;
  for (auto error = errors.begin(); error != errors.end(); ++error) {
    if (!std::isnan(*error)) {
      below = *error;
      continue;
    }
    const auto above = std::find_if(error, errors.end(), [](double other) { return !std::isnan(other); });
    if (above == errors.end()) {
      break;
    }
    std::fill(error, above, std::max(below, *above));
    error = above;
    below = *above;
  }
  return errors;
}

}  // namespace idiophone::fitting
