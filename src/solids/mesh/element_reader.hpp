#pragma once
// The elements of a mesh file, a range of them on each rank.

#include <mpi.h>

#include "idiophone/solids/mesh/meshes_in_parts.hpp"

namespace idiophone::mesh {

/// The first element of a rank's range.
[[nodiscard]] Index first_row(Index element_count, int rank, int ranks);

/// This rank's elements of a body with their material regions, compared with the checksums and the hash of the file.
/// Collective.
/// @param outline        on rank 0, in the axes of the file, with the hash that the file promises and no groups but the
///                       file's
/// @param element_count  of the body
/// @param node_count     of the body
/// @throws deck::DeckError on rank 0 and parallel::RemoteFailure elsewhere if they can't be read or are wrong, or
///         regions_by_group() would throw
[[nodiscard]] ElementRows read_element_rows(const scene::Body& body, const Mesh& outline, Index element_count,
                                            Index node_count, MPI_Comm communicator);

}  // namespace idiophone::mesh
