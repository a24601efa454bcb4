#pragma once
// What one rank needs of a body's mesh: the elements around its nodes, with all nodes of these.

#include <mpi.h>

#include <string>
#include <vector>

#include "gmsh_mesh.hpp"
#include "idiophone/solids/mesh/meshes_in_parts.hpp"

namespace idiophone::mesh {

/// The elements of a body that a rank computes: those that touch a node it owns.
struct Neighbourhood {
  /// Elements in the order of the scene, with regions. Tags are numbers in the file.
  GmshMesh loaded;
  std::vector<Index> numbers;  ///< [elements] in the body, region by region, ascending
};

/// Collective.
/// @param rows        this rank's range, which it gives away
/// @param body        whose elements they are
/// @param first_node  global number of the body's first node
/// @param first       [ranks + 1] first node of each rank, global
/// @return with elements that have numbers of nodes in the body, and without nodes
[[nodiscard]] Neighbourhood elements_around(ElementRows rows, const scene::Body& body, Index first_node,
                                            const std::vector<Index>& first, MPI_Comm communicator);

/// Gives the mesh its nodes' tags, ascending, and makes the elements refer to them by their places.
/// @param begin, end  the nodes that this rank owns, as numbers in the body
/// @param others      further nodes that it needs, likewise
/// @return what is wrong, for text_of_problem(): an owned node that no element has; empty for nothing
[[nodiscard]] std::string number_nodes(GmshMesh& loaded, Index begin, Index end, std::vector<Index> others);

/// Into how many parts that share no node the whole body falls. Collective.
/// @param loaded  of this rank, with numbered nodes
[[nodiscard]] Index count_connected(const GmshMesh& loaded, Index first_node, const std::vector<Index>& first,
                                    MPI_Comm communicator);

}  // namespace idiophone::mesh
