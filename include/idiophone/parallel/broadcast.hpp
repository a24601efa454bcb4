#pragma once
// What rank 0 knows, for all.

#include <mpi.h>

#include <cstdint>
#include <type_traits>

namespace idiophone::parallel {

/// Rank 0's container (a vector or string), on every rank. Its values are sent as bytes: the ranks of a job run the
/// same binary. Collective.
template <class Container>
void broadcast(Container& values, MPI_Comm communicator) {
  using Value = typename Container::value_type;
  static_assert(std::is_trivially_destructible_v<Value>, "values with pointers of their own can't be sent");
  auto count = static_cast<std::int64_t>(values.size());
  MPI_Bcast(&count, 1, MPI_INT64_T, 0, communicator);
  values.resize(static_cast<std::size_t>(count));
  MPI_Datatype type = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(sizeof(Value), MPI_BYTE, &type);
  MPI_Type_commit(&type);
  MPI_Bcast(values.data(), static_cast<int>(count), type, 0, communicator);
  MPI_Type_free(&type);
}

}  // namespace idiophone::parallel
