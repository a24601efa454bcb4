#include "idiophone/run/results/contact_spread.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace idiophone::results {

std::vector<std::string> spread_column_names() {
  std::vector<std::string> names;
  names.reserve(spread_columns.size());
  for (const auto& [first, second] : spread_columns) {
    names.push_back({"xyz"[first], "xyz"[second]});
  }
  return names;
}

std::array<double, spread_columns.size()> spread_row(const Eigen::Matrix3d& spread) {
  std::array<double, spread_columns.size()> row = {};
  for (std::size_t c = 0; c < row.size(); ++c) {
    row[c] = spread(spread_columns[c][0], spread_columns[c][1]);
  }
  return row;
}

Eigen::Matrix3d spread_of_row(std::span<const double> row) {
  if (row.size() != spread_columns.size()) {
    throw std::runtime_error(
        fmt::format("a series `spread` must have {} columns, not {}", spread_columns.size(), row.size()));
  }
  Eigen::Matrix3d spread;
  for (std::size_t c = 0; c < row.size(); ++c) {
    const auto [first, second] = spread_columns[c];
    spread(first, second) = spread(second, first) = row[c];
  }
  return spread;
}

}  // namespace idiophone::results
