#pragma once
// Four doubles or integers that are computed at once, whatever the instruction set: +, -, *, /, comparisons and ?: work
// lane by lane, and a lane's result never depends on the other lanes.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "idiophone/foundation/vector_register.hpp"

namespace idiophone {

inline constexpr std::size_t lane_count = 4;

using Lanes4 = double __attribute__((vector_size(lane_count * sizeof(double))));
using IntegerLanes4 = std::int64_t __attribute__((vector_size(lane_count * sizeof(std::int64_t))));

/// x, y, z of four vectors.
using VectorLanes = std::array<Lanes4, 3>;

/// As many doubles or integers as fill a register, but at least four: for arrays that are padded to eight.
inline constexpr std::size_t wide_count = register_size / sizeof(double) > lane_count ? 2 * lane_count : lane_count;
using WideLanes = double __attribute__((vector_size(wide_count * sizeof(double))));
using WideIntegers = std::int64_t __attribute__((vector_size(wide_count * sizeof(std::int64_t))));

inline constexpr std::size_t pack_size = 8;

/// Eight neighbours: what arrays are padded to, one cache line.
struct alignas(pack_size * sizeof(double)) AlignedBlock {
  std::array<double, pack_size> values;
};

/// The smallest multiple of 8 that is not below `count`: the length that arrays are padded to.
[[nodiscard]] constexpr std::size_t padded(std::size_t count) {
  return (count + pack_size - 1) / pack_size * pack_size;
}

/// Reads as many consecutive values as a vector has, aligned or not.
template <class Vector = Lanes4, class Value>
[[nodiscard]] inline Vector load(const Value* values) {
  static_assert(sizeof(std::declval<Vector>()[0]) == sizeof(Value));
  Vector lanes;
  std::memcpy(&lanes, values, sizeof lanes);
  return lanes;
}

/// Writes as many consecutive values as a vector has, aligned or not.
template <class Vector, class Value>
inline void put(const Vector& lanes, Value* values) {
  static_assert(sizeof(lanes[0]) == sizeof(Value));
  std::memcpy(values, &lanes, sizeof lanes);
}

/// Square root of each lane.
[[nodiscard]] inline Lanes4 square_root(const Lanes4& values) {
  Lanes4 roots;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    roots[lane] = std::sqrt(values[lane]);
  }
  return roots;
}

/// Turns four rows (x, y, z, anything) into the columns x, y, z.
[[nodiscard]] inline VectorLanes columns(const std::array<Lanes4, lane_count>& rows) {
  const Lanes4 even01 = __builtin_shufflevector(rows[0], rows[1], 0, 4, 2, 6);
  const Lanes4 even23 = __builtin_shufflevector(rows[2], rows[3], 0, 4, 2, 6);
  const Lanes4 odd01 = __builtin_shufflevector(rows[0], rows[1], 1, 5, 3, 7);
  const Lanes4 odd23 = __builtin_shufflevector(rows[2], rows[3], 1, 5, 3, 7);
  return {__builtin_shufflevector(even01, even23, 0, 1, 4, 5), __builtin_shufflevector(odd01, odd23, 0, 1, 4, 5),
          __builtin_shufflevector(even01, even23, 2, 3, 6, 7)};
}

}  // namespace idiophone
