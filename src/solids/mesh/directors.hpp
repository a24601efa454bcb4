#pragma once
// Which way a thin body's thickness lies.

#include <array>

#include "surface_mesh.hpp"

namespace idiophone::mesh {

/// Derivatives of a field that is given at the nodes, with respect to the directions of a quadrilateral on [-1, 1].
class QuadrilateralGradient {
 public:
  explicit QuadrilateralGradient(int order);

  /// @param nodes  of the quadrilateral
  /// @param at     place of one of them, where the derivatives are taken
  /// @param field  [nodes of the mesh]
  [[nodiscard]] std::array<Vector3, 2> operator()(std::span<const Index> nodes, Index at,
                                                  const std::vector<Vector3>& field) const;

 private:
  Index width_;             ///< nodes along a direction
  Eigen::MatrixXd slopes_;  ///< [node x polynomial]
};

/// The director of each node: the surface at x becomes a wall between x - h/2 d and x + h/2 d. It is the mean normal of
/// the quadrilaterals around the node over its mean projection on them. Zero at nodes without quadrilaterals. [nodes]
/// @throws deck::DeckError, pointing at the body's mesh key, when quadrilaterals are flat or meet at too sharp an edge
[[nodiscard]] std::vector<Vector3> directors_of(const scene::Body& body, const SurfaceMesh& surface);

}  // namespace idiophone::mesh
