#pragma once
// The faces of elements: who shares them, and which are the body's surface.

#include <functional>
#include <span>

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// One face of one element.
struct ElementFace {
  std::array<Index, 4> corners{};  ///< ascending node numbers: equal for the elements that share the face; a triangle's
                                   ///< three come after a -1
  Index element = 0;               ///< whose face it is
  Index side = 0;                  ///< its place among the element's faces (element::ReferenceElement)
};

/// Calls visit(faces) once for each set of faces with equal corners: of one element on the surface, of two inside.
/// Sets come by ascending corners, and the faces of a set by ascending element.
void for_each_shared_face(const Mesh& mesh, const std::function<void(std::span<const ElementFace>)>& visit);

/// The faces of a physical group on the outside of the body, by ascending corners; none where the group has none there.
/// @throws as find_group()
[[nodiscard]] std::vector<ElementFace> outer_faces(const Mesh& mesh, const std::string& group,
                                                   const deck::Location& where);

/// The same triangle and orientation, smallest node first.
void turn_smallest_first(Triangle& triangle);

/// The straight triangles that cover a face, turned out of its element, the smallest node first.
void append_triangles(const Mesh& mesh, const ElementFace& face, std::vector<Triangle>& triangles);

/// Exterior triangles of a mesh without inverted elements, turned outward and sorted as Mesh::surface says.
[[nodiscard]] std::vector<Triangle> exterior_triangles(const Mesh& mesh);

}  // namespace idiophone::mesh
