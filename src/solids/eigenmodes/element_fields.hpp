#pragma once
// Fields of finite elements at the quadrature points of their elements, for integrals that are exact where the elements
// are parallelepipeds.

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::eigenmodes {

/// Shape functions at the quadrature points of one element.
struct ShapeTable {
  Eigen::MatrixXd values;                 ///< [points x nodes]
  std::array<Eigen::MatrixXd, 3> slopes;  ///< [axes][points x nodes] dN_a/dX_k, 1/m
};

/// The quadrature points of one element.
struct ElementPoints {
  Eigen::VectorXd weights;                                ///< [points] with the Jacobian, m3
  std::array<std::array<Eigen::VectorXd, 3>, 3> inverse;  ///< [k][l][points] dxi_k/dX_l, 1/m
};

/// A type of hexahedra at given points of the reference element.
class ShapesAtPoints {
 public:
  /// @param type    hexahedra
  /// @param points  [points] xi
  ShapesAtPoints(element::Type type, const std::vector<Vector3>& points);

  /// Of an element of a mesh of this type. `weights` are those of the reference element.
  [[nodiscard]] ElementPoints points_of(const mesh::Mesh& mesh, Index element, const Eigen::VectorXd& weights) const;

  /// On an element with these points.
  [[nodiscard]] ShapeTable on(const ElementPoints& points) const;

 private:
  ShapeTable reference_;  ///< slopes are dN_a/dxi_k
};

/// A rule of Gauss, Lobatto and Legendre in the reference cube. It integrates products of two shape functions exactly
/// on parallelepipeds, with three to five degrees to spare for other elements.
struct CubeRule {
  explicit CubeRule(element::Type type);

  std::vector<Vector3> points;
  Eigen::VectorXd weights;
};

/// Displacements of some modes at the points of an element, and their strains.
struct ModeFields {
  /// @param shapes  [3 x nodes of the mesh, modes]
  ModeFields(const ShapeTable& table, std::span<const Index> nodes, const Eigen::MatrixXd& shapes);

  std::array<Eigen::MatrixXd, 3> displacement;  ///< [axes][points x modes], m
  std::array<Eigen::MatrixXd, 6> strain;        ///< [solid::direction_pairs][points x modes]; shear strains twice
};

/// The rows of an array of matrices, times a matrix: sum_s matrix(r, s) fields[s].
[[nodiscard]] std::array<Eigen::MatrixXd, 6> combined(const Eigen::Matrix<double, 6, 6>& matrix,
                                                      const std::array<Eigen::MatrixXd, 6>& fields);

/// Adds the integral of sum_r a_r b_r over an element. [modes of a x modes of b]
template <std::size_t count>
void add_integral(const Eigen::VectorXd& weights, const std::array<Eigen::MatrixXd, count>& a,
                  const std::array<Eigen::MatrixXd, count>& b, Eigen::MatrixXd& sum) {
  for (std::size_t r = 0; r < count; ++r) {
    sum += a[r].transpose() * (weights.asDiagonal() * b[r]);
  }
}

}  // namespace idiophone::eigenmodes
