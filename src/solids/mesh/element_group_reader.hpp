#pragma once
// The groups of elements of a mesh file, as far as they lie in a rank's range of the elements.

#include <mpi.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/scene/body.hpp"

namespace idiophone::mesh {

/// Each rank reads a range of the members, compares it with the checksum, and gives it to the ranks that have these
/// elements. Collective.
/// @param element_count  of the body
/// @return all groups, with their elements in this rank's range (first_row()), by ascending numbers in the file
/// @throws deck::DeckError on rank 0 and parallel::RemoteFailure elsewhere if they can't be read or are wrong
[[nodiscard]] std::map<std::string, std::vector<std::size_t>> read_element_groups(const scene::Body& body,
                                                                                  Index element_count,
                                                                                  MPI_Comm communicator);

}  // namespace idiophone::mesh
