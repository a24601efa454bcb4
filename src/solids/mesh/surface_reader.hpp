#pragma once
// The triangles of the surface that the ranks of one process own.

#include <mpi.h>

#include <span>
#include <vector>

#include "curve_division.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

struct SurfaceRows {
  std::vector<Index> numbers;       ///< [triangles] in the body, ascending
  std::vector<Triangle> triangles;  ///< as places of their nodes in `node_tags`
};

/// Reads the triangles whose lowest nodes this process has. Collective.
/// @param outline     on rank 0
/// @param first_node  global number of the body's first node
/// @param node_tags   numbers in the body of this process's nodes, ascending
/// @throws deck::DeckError on rank 0 and parallel::RemoteFailure elsewhere if they can't be read, or one has a node
///         that is on no element
[[nodiscard]] SurfaceRows surface_around(const scene::Body& body, const Mesh& outline, Index first_node,
                                         std::span<const std::size_t> node_tags, const NodeDivision& division,
                                         MPI_Comm communicator);

}  // namespace idiophone::mesh
