#pragma once
// Numbers that a mesh file gives its nodes and elements.

#include <string>
#include <vector>

#include "idiophone/scene/body.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// One view of a .msh file: $NodeData or $ElementData with one number for each node or element.
struct MeshValues {
  std::string name;           ///< of the view
  bool of_elements = false;   ///< of elements; otherwise of nodes
  std::vector<double> value;  ///< [nodes or elements] in the mesh's order, in the unit of the file
};

struct ValuedMesh {
  Mesh mesh;
  std::vector<MeshValues> values;  ///< of all views, in the order of the file; other formats have none
};

/// The mesh of a body, as read_mesh(), with what its file says of its nodes and elements.
/// @throws deck::DeckError as read_mesh(), and for a view with vectors or several time steps, without a value for each
///         node or element of the body, or with a value that is not finite
[[nodiscard]] ValuedMesh read_mesh_with_values(const scene::Body& body);

}  // namespace idiophone::mesh
