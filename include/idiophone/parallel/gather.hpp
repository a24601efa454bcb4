#pragma once
// What all ranks know, on every rank.

#include <mpi.h>

#include <numeric>
#include <span>
#include <vector>

#include "idiophone/parallel/communicator.hpp"
#include "idiophone/parallel/datatype.hpp"

namespace idiophone::parallel {

/// Where each rank's values begin in a list of all ranks' values.
[[nodiscard]] inline std::vector<int> offsets_of(const std::vector<int>& counts) {
  std::vector<int> offsets(counts.size());
  std::exclusive_scan(counts.begin(), counts.end(), offsets.begin(), 0);
  return offsets;
}

/// All ranks' values, one rank's after another's.
template <class Value>
struct Gathered {
  std::vector<Value> values;
  std::vector<int> counts;   ///< [ranks] how many values
  std::vector<int> offsets;  ///< [ranks] where they begin
};

/// One value of each rank, [ranks]. Collective.
template <class Value>
[[nodiscard]] std::vector<Value> gather(const Value& value, MPI_Comm communicator) {
  const Datatype type = Datatype::of<Value>();
  std::vector<Value> all(size_of(communicator));
  MPI_Allgather(&value, 1, type.get(), all.data(), 1, type.get(), communicator);
  return all;
}

/// Any number of values of each rank. Collective.
template <class Value>
[[nodiscard]] Gathered<Value> gather_all(std::span<const Value> values, MPI_Comm communicator) {
  const Datatype type = Datatype::of<Value>();
  Gathered<Value> all;
  all.counts = gather(static_cast<int>(values.size()), communicator);
  all.offsets = offsets_of(all.counts);
  all.values.resize(all.offsets.back() + all.counts.back());
  MPI_Allgatherv(values.data(), static_cast<int>(values.size()), type.get(), all.values.data(), all.counts.data(),
                 all.offsets.data(), type.get(), communicator);
  return all;
}

}  // namespace idiophone::parallel
