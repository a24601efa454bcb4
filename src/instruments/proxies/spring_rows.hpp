#pragma once
// One vector for each mass or spring, in single precision: x, y, z and a zero. The sound of a proxy has errors of its
// lattice that are far above those of rounding, and rows of half the length are computed in half the time.

#include <Eigen/Core>
#include <cstring>
#include <span>
#include <vector>

#include "idiophone/foundation/lanes.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::proxies {

using RowLanes = float __attribute__((vector_size(lane_count * sizeof(float))));

struct Row {
  RowLanes lanes{};
};

inline constexpr std::size_t rows_at_once = 4;  // a cache line

/// Four rows that are computed at once.
using FourRows = float __attribute__((vector_size(rows_at_once * sizeof(Row))));

/// A field of vectors, aligned, padded with zero rows to whole FourRows.
using Rows = std::vector<Row, Eigen::aligned_allocator<Row>>;

[[nodiscard]] inline std::size_t padded_rows(std::size_t count) {
  return (count + rows_at_once - 1) / rows_at_once * rows_at_once;
}

[[nodiscard]] inline Row row_of(const Vector3& vector) {
  return {RowLanes{static_cast<float>(vector[0]), static_cast<float>(vector[1]), static_cast<float>(vector[2]), 0.0F}};
}

[[nodiscard]] inline Vector3 vector_of(const Row& row) {
  return {row.lanes[0], row.lanes[1], row.lanes[2]};
}

[[nodiscard]] inline FourRows four_rows(const Rows& rows, std::size_t first) {
  FourRows four;
  std::memcpy(&four, &rows[first].lanes, sizeof four);
  return four;
}

inline void put_four_rows(const FourRows& four, Rows& rows, std::size_t first) {
  std::memcpy(&rows[first].lanes, &four, sizeof four);
}

/// Sum of the products of two fields of the same padded length, in a fixed order.
[[nodiscard]] inline double dot(const Rows& a, const Rows& b) {
  FourRows sum{};
  for (std::size_t i = 0; i < a.size(); i += rows_at_once) {
    sum += four_rows(a, i) * four_rows(b, i);
  }
  double total = 0.0;
  for (std::size_t lane = 0; lane < rows_at_once * lane_count; ++lane) {
    total += sum[lane];
  }
  return total;
}

}  // namespace idiophone::proxies
