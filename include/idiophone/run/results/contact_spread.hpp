#pragma once
// The rows of the series contacts/NAME/spread.

#include <Eigen/Core>
#include <array>
#include <span>
#include <string>
#include <vector>

namespace idiophone::results {

/// Which two axes each column is of.
inline constexpr std::array<std::array<int, 2>, 6> spread_columns = {{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

/// "xx", "yy" and so on.
[[nodiscard]] std::vector<std::string> spread_column_names();

/// @param spread  symmetric
[[nodiscard]] std::array<double, spread_columns.size()> spread_row(const Eigen::Matrix3d& spread);

/// The symmetric matrix of a row. @throws std::runtime_error where a row has another number of columns
[[nodiscard]] Eigen::Matrix3d spread_of_row(std::span<const double> row);

}  // namespace idiophone::results
