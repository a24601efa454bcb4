#pragma once
// Geometry of one tetrahedron with 4 or 10 nodes.

#include "idiophone/mesh/mesh.hpp"

namespace idiophone::mesh {

/// The node positions of one element.
struct ElementShape {
  ElementType type = ElementType::tet4;
  std::array<Vector3, 10> nodes;  ///< [nodes per element], m; unused beyond
};

/// Shape of element `number`.
[[nodiscard]] ElementShape shape_of(const Mesh& mesh, Index number);

/// Mean of the corners, m.
[[nodiscard]] Vector3 centre_of(const ElementShape& shape);

/// Lengths of the six edges 01, 12, 02, 03, 13, 23 between corners, m.
[[nodiscard]] std::array<double, 6> edge_lengths(const ElementShape& shape);

/// Volume by the element's quadrature (one point, or four in a tet10), m3; negative when inverted.
[[nodiscard]] double volume_of(const ElementShape& shape);

/// Quality as defined in Statistics; negative where the element is inverted at any of its corners or quadrature points.
[[nodiscard]] double quality_of(const ElementShape& shape);

}  // namespace idiophone::mesh
