#pragma once
// Lists that every rank sends to every other.

#include <mpi.h>

#include <span>
#include <vector>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/datatype.hpp"
#include "idiophone/foundation/parallel/gather.hpp"

namespace idiophone::parallel {

/// What all ranks sent to this one: rank 0's items first, each rank's in its order. Collective.
/// @param items   for rank 0, then for rank 1, ...: rows of `width` values
/// @param counts  [ranks] rows for each
template <class Value>
[[nodiscard]] std::vector<Value> exchange(std::span<const Value> items, const std::vector<int>& counts,
                                          MPI_Comm communicator, std::size_t width = 1) {
  std::vector<int> taken(size_of(communicator));
  MPI_Alltoall(counts.data(), 1, MPI_INT, taken.data(), 1, MPI_INT, communicator);
  const std::vector<int> from = offsets_of(counts), to = offsets_of(taken);
  const Datatype row = Datatype::bytes(width * sizeof(Value));
  std::vector<Value> received(width * static_cast<std::size_t>(to.back() + taken.back()));
  MPI_Alltoallv(items.data(), counts.data(), from.data(), row.get(), received.data(), taken.data(), to.data(),
                row.get(), communicator);
  return received;
}

}  // namespace idiophone::parallel
