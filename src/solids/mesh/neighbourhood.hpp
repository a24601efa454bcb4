#pragma once
// What one process needs of a body's mesh: the elements around its nodes, with all nodes of these.

#include <mpi.h>

#include <span>
#include <string>
#include <vector>

#include "curve_division.hpp"
#include "gmsh_mesh.hpp"
#include "idiophone/solids/mesh/meshes_in_parts.hpp"

namespace idiophone::mesh {

/// The elements of a body that a process computes: those that touch a node it owns.
struct Neighbourhood {
  /// Elements in the order of the scene, with regions. Tags are numbers in the file.
  GmshMesh loaded;
  std::vector<Index> numbers;  ///< [elements] in the body, region by region, ascending
};

/// Collective.
/// @param rows        this process's range, which it gives away
/// @param body        whose elements they are
/// @param first_node  global number of the body's first node
/// @param division    of the nodes, global
/// @return with elements that have numbers of nodes in the body, and without nodes
[[nodiscard]] Neighbourhood elements_around(ElementRows rows, const scene::Body& body, Index first_node,
                                            const NodeDivision& division, MPI_Comm communicator);

/// Gives the outline on rank 0 the elements that have any of some nodes, in the order of the scene. Collective.
/// @param rows     this process's range
/// @param nodes    on rank 0: numbers in the body, ascending
/// @param outline  of the body, on rank 0
void give_root_elements(const ElementRows& rows, const scene::Body& body, std::vector<Index> nodes, Mesh& outline,
                        MPI_Comm communicator);

/// Gives the mesh its nodes' tags, ascending, and makes the elements refer to them by their places.
/// @param begin, end  the range of the nodes that this process owns, as numbers in the body
/// @param away        ascending, those in the range that others own
/// @param others      further nodes that it needs
/// @return what is wrong, for text_of_problem(): an owned node that no element has; empty for nothing
[[nodiscard]] std::string number_nodes(GmshMesh& loaded, Index begin, Index end, std::span<const Index> away,
                                       std::vector<Index> others);

/// Into how many parts that share no node the whole body falls. Collective.
/// @param loaded  of this process, with numbered nodes
[[nodiscard]] Index count_connected(const GmshMesh& loaded, Index first_node, const NodeDivision& division,
                                    MPI_Comm communicator);

}  // namespace idiophone::mesh
