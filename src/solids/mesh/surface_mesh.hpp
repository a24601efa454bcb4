#pragma once
// The quadrilaterals of a thin body's middle surface.

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// In gmsh's order, with the numbers ("tags") by which the file and gmsh know its parts.
struct SurfaceMesh {
  int order = 1;                          ///< of all quadrilaterals
  std::vector<Vector3> nodes;             ///< m
  std::vector<std::size_t> node_tags;     ///< [nodes]
  std::vector<Index> elements;            ///< [(order + 1)^2 x quadrilaterals] as gmsh_quadrilateral_nodes has them
  std::vector<std::size_t> element_tags;  ///< [quadrilaterals]
  std::map<std::string, std::vector<Index>> groups;  ///< physical group -> its nodes, ascending

  /// Nodes of one quadrilateral, [(order + 1)^2].
  [[nodiscard]] std::span<const Index> quadrilateral(Index number) const {
    const auto width = static_cast<std::size_t>(order) + 1;
    return std::span(elements).subspan(number * width * width, width * width);
  }
};

/// Turns quadrilaterals over, so that all neighbours face the same side.
/// @throws deck::DeckError, pointing at the body's mesh key, when more than two share an edge or the surface has one
/// side only; it names elements.
void orient(const scene::Body& body, SurfaceMesh& surface);

/// "element 5 at (0, 0.1, 0)": a quadrilateral in a message.
[[nodiscard]] std::string quadrilateral_text(const SurfaceMesh& surface, Index number);

}  // namespace idiophone::mesh
