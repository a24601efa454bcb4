#pragma once
// Geometry of one element.

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

inline constexpr double flat_quality = 1e-6;  ///< an element with less quality_of is flat but for rounding

/// The node positions of one element.
struct ElementShape {
  element::Type type;
  std::vector<Vector3> nodes;  ///< [nodes per element], m
};

/// Shape of element `number`.
[[nodiscard]] ElementShape shape_of(const Mesh& mesh, Index number);

/// Mean of the corners, m.
[[nodiscard]] Vector3 centre_of(const ElementShape& shape);

/// Lengths of the edges between corners, m, in the order of element::ReferenceElement.
[[nodiscard]] std::vector<double> edge_lengths(const ElementShape& shape);

/// Volume by the element's quadrature, m3; negative when inverted.
[[nodiscard]] double volume_of(const ElementShape& shape);

/// Quality as defined in Statistics; negative where the element is inverted at any of its corners or quadrature points.
[[nodiscard]] double quality_of(const ElementShape& shape);

}  // namespace idiophone::mesh
