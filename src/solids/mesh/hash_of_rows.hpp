#pragma once
// The hash of a mesh whose elements no rank has all of.

#include <mpi.h>

#include <string>

#include "idiophone/solids/mesh/meshes_in_parts.hpp"

namespace idiophone::mesh {

/// hash_of() of a mesh whose elements are numbered region by region. Collective.
/// @param outline        the rest of the mesh, on rank 0
/// @param rows           this rank's elements
/// @param element_count  over all ranks
/// @return on all ranks
[[nodiscard]] std::string hash_of_rows(const Mesh& outline, const ElementRows& rows, Index element_count,
                                       MPI_Comm communicator);

}  // namespace idiophone::mesh
