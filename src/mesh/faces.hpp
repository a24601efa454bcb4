#pragma once
// The faces of elements: who shares them, and which are the body's surface.

#include "idiophone/mesh/mesh.hpp"

namespace idiophone::mesh {

/// One face of one element.
struct ElementFace {
  std::array<Index, 4> corners{};  ///< ascending node numbers: equal for the elements that share the face; a triangle's
                                   ///< three come after a -1
  Index element = 0;               ///< whose face it is
  Index side = 0;                  ///< its place among the element's faces (element::ReferenceElement)
};

/// All faces of all elements, [faces of an element x elements], those with equal corners side by side.
[[nodiscard]] std::vector<ElementFace> sorted_faces(const Mesh& mesh);

/// Exterior triangles of a mesh without inverted elements, turned outward and sorted as Mesh::surface says.
[[nodiscard]] std::vector<Triangle> exterior_triangles(const Mesh& mesh);

}  // namespace idiophone::mesh
