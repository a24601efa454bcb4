#pragma once
// Mesh files whose elements no rank has all of. Each rank reads a range of the elements and gives them to the ranks
// that compute them. Rank 0 has the outlines: the nodes, the surfaces and the groups.
//
// A rank owns a range of the numbers of the nodes, which run along a space-filling curve: METIS would need the whole
// mesh. Of bodies with mass scaling, it owns whole columns. The parts are otherwise those of distribute(), so a run has
// the same bits.

#include <mpi.h>

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/mesh/statistics.hpp"

namespace idiophone::mesh {

/// Whether a body's mesh can be read in parts: it is a mesh file.
[[nodiscard]] bool fits_parts(const scene::Body& body);

/// Elements of a mesh file; none where it can't be read.
[[nodiscard]] std::optional<Index> stored_elements(const scene::Body& body);

/// Elements of a body with numbers one after another in its file.
struct ElementRows {
  Index begin = 0;                   ///< number of the first one
  std::vector<Index> nodes;          ///< [nodes per element x elements] numbers in the body
  std::vector<Index> regions;        ///< [elements] as Mesh::regions, but in the order of the file
  std::vector<Index> region_counts;  ///< [regions] elements of each on all ranks; empty where there is one material
};

/// What a rank has read before the parts are known.
struct MeshShares {
  std::vector<Mesh> outlines;     ///< on rank 0, of all bodies, in their places, without elements; empty elsewhere
  Offsets offsets;                ///< on all ranks
  std::vector<ElementRows> rows;  ///< [bodies] that this rank has read
};

/// Reads all of the meshes but the nodes and the surface, which only rank 0 has yet, and compares them with the hashes.
/// Collective.
/// @param bodies  that fit_parts()
/// @throws deck::DeckError on rank 0, as read_meshes(), and parallel::RemoteFailure elsewhere
[[nodiscard]] MeshShares read_shares(std::span<const scene::Body> bodies, MPI_Comm communicator);

/// Gives the outlines the elements that have any of some nodes, in the order of the meshes. Collective.
/// @param meshes  with rows
/// @param nodes   on rank 0, [bodies] numbers in the body, ascending
void give_root_elements(std::span<const scene::Body> bodies, MeshShares& meshes, std::vector<std::vector<Index>> nodes,
                        MPI_Comm communicator);

struct ReadPart {
  Part part;                           ///< of this rank
  std::vector<Statistics> statistics;  ///< [bodies], on rank 0. Sums over elements depend on the ranks by rounding
};

/// Gives the elements to the ranks that compute them, checks them as read_meshes() does, and makes the parts.
/// Collective.
/// @param meshes   of the bodies; their rows are used up
/// @param coupled  as distribute() takes them, but on all ranks
/// @throws deck::DeckError on rank 0, and parallel::RemoteFailure elsewhere, for a file that can't be read, or that has
///         unfit elements; std::runtime_error, on every rank, where there are too many ranks
[[nodiscard]] ReadPart read_part(std::span<const scene::Body> bodies, MeshShares& meshes,
                                 std::span<const std::vector<Index>> coupled, MPI_Comm communicator);

/// Calls visit(part) with the part of each of so many ranks, as read_part() would make them, but in the axes of the
/// files, and without checks. Each process visits some, one after another: process 0 the first ones. Collective.
/// @param outlines  on rank 0
/// @param rows      [bodies] as read_shares() gives them; they are used up
/// @param ranks     that share the bodies, at least as many as processes
/// @throws as read_part(), but not for unfit elements
void for_each_part_in_rows(std::span<const scene::Body> bodies, const std::vector<Mesh>& outlines,
                           const Offsets& offsets, std::vector<ElementRows>& rows,
                           std::span<const std::vector<Index>> coupled, int ranks,
                           const std::function<void(const Part&)>& visit, MPI_Comm communicator);

}  // namespace idiophone::mesh
