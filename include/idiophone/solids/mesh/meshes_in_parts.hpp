#pragma once
// Mesh files whose elements no rank has all of. Each rank reads a range of the elements and gives them to the ranks
// that compute them. Rank 0 has the outlines: the nodes, the surfaces and the groups.
//
// A rank owns a range of the numbers of the nodes, which run along a space-filling curve: METIS would need the whole
// mesh. The parts are otherwise those of distribute(), so a run has the same bits.

#include <mpi.h>

#include <optional>
#include <span>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/mesh/statistics.hpp"

namespace idiophone::mesh {

/// Whether a body's mesh can be read in parts: it is a mesh file, which keeps its numbers in the scene as it has one
/// material and the place of its file; and its elements are tetrahedra, of which nothing but the ghosts need others.
[[nodiscard]] bool fits_parts(const scene::Body& body);

/// Elements of a mesh file; none where it can't be read.
[[nodiscard]] std::optional<Index> stored_elements(const scene::Body& body);

/// What is known without elements.
struct Outlines {
  std::vector<Mesh> meshes;  ///< on rank 0, of all bodies, without elements; empty elsewhere
  Offsets offsets;           ///< on all ranks
};

/// Collective.
/// @param bodies  that fit_parts()
/// @throws deck::DeckError on rank 0, as read_meshes(), and parallel::RemoteFailure elsewhere
[[nodiscard]] Outlines read_outlines(std::span<const scene::Body> bodies, MPI_Comm communicator);

struct ReadPart {
  Part part;                           ///< of this rank
  std::vector<Statistics> statistics;  ///< [bodies], on rank 0. Sums over elements depend on the ranks by rounding
};

/// Reads the elements, checks them as read_meshes() does, and makes the parts. Collective.
/// @param outlines  of the bodies
/// @param coupled   as distribute() takes them, but on all ranks
/// @throws deck::DeckError on rank 0, and parallel::RemoteFailure elsewhere, for a file that can't be read, is damaged,
///         or has unfit elements; std::runtime_error, on every rank, where there are too many ranks
[[nodiscard]] ReadPart read_part(std::span<const scene::Body> bodies, const Outlines& outlines,
                                 std::span<const std::vector<Index>> coupled, MPI_Comm communicator);

}  // namespace idiophone::mesh
