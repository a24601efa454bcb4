#pragma once
// The faces of tetrahedra: who shares them, and which are the body's surface.

#include "idiophone/mesh/mesh.hpp"

namespace idiophone::mesh {

/// One face of one element.
struct Face {
  Triangle corners{};  ///< ascending node numbers: equal for the elements that share the face
  Index element = 0;   ///< whose face it is
  Index side = 0;      ///< 0 to 3
};

/// All faces of all elements, [4 x elements], those with equal corners side by side.
[[nodiscard]] std::vector<Face> sorted_faces(const Mesh& mesh);

/// Exterior triangles of a mesh without inverted elements, turned outward and sorted as Mesh::surface says.
[[nodiscard]] std::vector<Triangle> exterior_triangles(const Mesh& mesh);

}  // namespace idiophone::mesh
