#pragma once
// Statistics of a mesh whose elements no rank has all of.

#include <mpi.h>

#include <span>
#include <vector>

#include "idiophone/solids/mesh/statistics.hpp"

namespace idiophone::mesh {

/// Collective.
/// @param outline  of the body, on rank 0
/// @param own      this rank's part of the mesh
/// @param owned    [elements of it] 1 for those that count here
/// @param numbers  [elements of it] in the body
/// @param regions  how many the body has; 0 for one material
/// @return on rank 0. Sums over elements depend on the ranks by rounding
[[nodiscard]] Statistics gathered_statistics(const Mesh& outline, const Mesh& own, std::span<const char> owned,
                                             std::span<const Index> numbers, std::size_t regions,
                                             MPI_Comm communicator);

}  // namespace idiophone::mesh
