#pragma once
// The faces of a mesh that lie on the fracture surfaces of its body.

#include <vector>

#include "idiophone/solids/mesh/faces.hpp"

namespace idiophone::mesh {

/// Two elements that touch on a fracture surface.
struct TouchingFaces {
  std::size_t surface;  ///< its place in scene::Body::fracture
  std::array<ElementFace, 2> sides;
};

struct FractureSurfaces {
  std::vector<TouchingFaces> faces;  ///< by ascending corners
  std::vector<ElementFace> outside;  ///< all faces of the body's surface, likewise
  std::vector<char> on_them;         ///< [nodes] 1 where the node is on one of the faces
};

/// A face of linear tetrahedra is on a surface if it is a triangle of the physical group of that name, another face if
/// all its nodes are in the group.
/// @throws deck::DeckError, pointing at the surface, when the mesh has no such group, or the surface has no faces
/// inside
///         the body, lies on the outside of the body, or shares faces with another one.
[[nodiscard]] FractureSurfaces find_fracture_surfaces(const Mesh& mesh, const scene::Body& body);

}  // namespace idiophone::mesh
