#include "idiophone/solids/modal_bodies/stretching.hpp"

namespace idiophone::modal_bodies {

namespace {

/// The first columns of the first rows of each matrix.
/// @param matrices  [count x old rows x old columns], old rows and old columns at least those that stay
std::vector<double> corners_of(const std::vector<double>& matrices, std::size_t count, std::size_t old_rows,
                               std::size_t old_columns, std::size_t rows, std::size_t columns) {
  std::vector<double> corners;
  for (std::size_t matrix = 0; matrix < count; ++matrix) {
    for (std::size_t row = 0; row < rows; ++row) {
      const auto first = matrices.begin() + static_cast<std::ptrdiff_t>((matrix * old_rows + row) * old_columns);
      corners.insert(corners.end(), first, first + static_cast<std::ptrdiff_t>(columns));
    }
  }
  return corners;
}

}  // namespace

Stretching Stretching::of_first(std::size_t modes) const {
  if (!exists()) {
    return {};
  }
  const std::size_t all = linear.size() / terms();
  return {.linear = corners_of(linear, 1, terms(), all, terms(), modes),
          .quadratic = corners_of(quadratic, terms(), all, all, modes, modes),
          .rotation = corners_of(rotation, 1, all, all, modes, modes)};
}

}  // namespace idiophone::modal_bodies
