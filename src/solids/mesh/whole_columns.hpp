#pragma once
// Columns of nodes through the thickness that one rank owns, where a rank otherwise owns a range of numbers.

#include <mpi.h>

#include <vector>

#include "curve_division.hpp"
#include "idiophone/solids/mesh/meshes_in_parts.hpp"

namespace idiophone::mesh {

/// Gives the columns of bodies with mass scaling to the owners of their lowest nodes: [nodes] those that move for it,
/// ascending. Where elements do not agree about a column, which mass scaling refuses later, nodes move to one of its
/// owners. Collective.
/// @param rows   [bodies] this process's range
/// @param nodes  [bodies + 1] global number of each body's first node
/// @param first  as WorkOfNodes::divide() gives it
[[nodiscard]] std::vector<MovedNode> nodes_moved_to_columns(std::span<const scene::Body> bodies,
                                                            const std::vector<ElementRows>& rows,
                                                            const std::vector<Index>& nodes,
                                                            const std::vector<Index>& first, MPI_Comm communicator);

}  // namespace idiophone::mesh
