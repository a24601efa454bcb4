#pragma once
// The elements of a mesh file, a range of them on each rank.

#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// Elements with numbers one after another.
struct ElementRows {
  Index begin = 0;           ///< number of the first one
  std::vector<Index> nodes;  ///< [nodes per element x elements]
};

/// This rank's of a body, compared with the checksum and the hash of the file. Collective.
/// @param outline        on rank 0
/// @param element_count  of the body
/// @param node_count     of the body
/// @throws deck::DeckError on rank 0 and parallel::RemoteFailure elsewhere if they can't be read or are wrong
[[nodiscard]] ElementRows read_element_rows(const scene::Body& body, const Mesh& outline, Index element_count,
                                            Index node_count, MPI_Comm communicator);

/// Throws one error for all ranks. Collective.
/// @param problem  of this rank; empty for none
/// @throws deck::DeckError on rank 0, pointing at the body's mesh key, and parallel::RemoteFailure elsewhere, with the
///         lowest failing rank's problem
void require_none(const scene::Body& body, const std::string& problem, MPI_Comm communicator);

/// Calls `read()` on every rank, within the limit for reading the body's file. It makes no collective call. Collective.
/// @throws as require_none() if it throws a std::runtime_error on any rank
void read_together(const scene::Body& body, MPI_Comm communicator, const std::function<void()>& read);

}  // namespace idiophone::mesh
