#pragma once
// The material regions of elements that ranks have read.

#include <mpi.h>

#include "idiophone/solids/mesh/meshes_in_parts.hpp"

namespace idiophone::mesh {

/// Gives this rank's elements of a body their regions, if the body has several materials. The groups of elements are
/// read and compared with their checksums in any case. Collective.
/// @param element_count  of the body
/// @throws deck::DeckError on rank 0 and parallel::RemoteFailure elsewhere if the groups can't be read or are wrong, or
///         regions_by_group() would throw
void read_regions(const scene::Body& body, Index element_count, ElementRows& rows, MPI_Comm communicator);

}  // namespace idiophone::mesh
