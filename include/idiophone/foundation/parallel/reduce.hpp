#pragma once
// Sums and extremes over ranks. A sum of doubles is only reproducible where all ranks but one add zeros: for other sums
// see reproducible_sum.hpp.

#include <mpi.h>

#include <algorithm>
#include <ranges>
#include <span>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/datatype.hpp"

namespace idiophone::parallel {

/// Replaces each value by that of all ranks. Collective.
template <class Number>
void reduce(std::span<Number> values, MPI_Op operation, MPI_Comm communicator) {
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), number_type<Number>(), operation,
                communicator);
}

/// Replaces each value of a contiguous range (array, vector) by that of all ranks. Collective.
template <class Numbers>
void reduce(Numbers& numbers, MPI_Op operation, MPI_Comm communicator) {
  reduce(std::span<std::ranges::range_value_t<Numbers>>(numbers), operation, communicator);
}

/// The sum of all ranks' values. Collective.
template <class Number>
[[nodiscard]] Number sum(Number value, MPI_Comm communicator) {
  reduce(std::span(&value, 1), MPI_SUM, communicator);
  return value;
}

/// The largest of all ranks' values. Collective.
template <class Number>
[[nodiscard]] Number largest(Number value, MPI_Comm communicator) {
  reduce(std::span(&value, 1), MPI_MAX, communicator);
  return value;
}

/// The smallest of all ranks' values. Collective.
template <class Number>
[[nodiscard]] Number smallest(Number value, MPI_Comm communicator) {
  reduce(std::span(&value, 1), MPI_MIN, communicator);
  return value;
}

/// Replaces each of rank 0's values by the sum of all ranks' values; leaves the other ranks' values. Collective.
/// @param values  as many on every rank
template <class Number>
void sum_on_root(std::span<Number> values, MPI_Comm communicator) {
  constexpr std::size_t at_once = 1UL << 25U;  // MPI counts are 32-bit
  const bool root = is_root(communicator);
  for (std::size_t first = 0; first < values.size(); first += at_once) {
    Number* const numbers = &values[first];
    MPI_Reduce(root ? MPI_IN_PLACE : numbers, numbers, static_cast<int>(std::min(at_once, values.size() - first)),
               number_type<Number>(), MPI_SUM, 0, communicator);
  }
}

}  // namespace idiophone::parallel
