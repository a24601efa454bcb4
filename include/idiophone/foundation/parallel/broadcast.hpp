#pragma once
// What one rank knows, on all ranks. Values are sent as bytes: the ranks of a job run the same binary. All collective.

#include <mpi.h>

#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

#include "idiophone/foundation/parallel/datatype.hpp"

namespace idiophone::parallel {

/// A vector of plain values, or a string.
template <class Container>
concept PlainContainer = std::is_trivially_destructible_v<typename Container::value_type> &&
    requires(Container values) {
  values.resize(1);
};

/// A number, an enum, or a struct of these.
template <class Value>
concept PlainValue = std::is_trivially_copyable_v<Value> && !std::is_pointer_v<Value>;

/// Takes the value of rank `root`.
template <PlainValue Value>
void broadcast(Value& value, MPI_Comm communicator, int root = 0) {
  MPI_Bcast(&value, sizeof value, MPI_BYTE, root, communicator);
}

/// Takes the values of rank `root`, as many as it has.
template <PlainContainer Container>
void broadcast(Container& values, MPI_Comm communicator, int root = 0) {
  auto count = static_cast<std::int64_t>(values.size());
  broadcast(count, communicator, root);
  values.resize(count);
  MPI_Bcast(values.data(), static_cast<int>(count), Datatype::of<typename Container::value_type>().get(), root,
            communicator);
}

/// Takes rank 0's texts.
inline void broadcast(std::vector<std::string>& texts, MPI_Comm communicator) {
  auto count = static_cast<std::int64_t>(texts.size());
  broadcast(count, communicator);
  texts.resize(count);
  for (std::string& text : texts) {
    broadcast(text, communicator);
  }
}

/// Rank 0's text or texts.
template <class Value>
[[nodiscard]] Value from_root(Value value, MPI_Comm communicator) {
  broadcast(value, communicator);
  return value;
}

}  // namespace idiophone::parallel
