#pragma once
// Strains at the quadrature points of a body as vectors: their product is twice an elastic energy.

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/elasticity.hpp"

namespace idiophone::eigenmodes {

/// A strain e is the vector of sqrt(v) L^T e at all quadrature points: v is the volume of a point (m3), C = L L^T the
/// stiffness, and shears count twice in e. So the product of two strains is the integral of e : C : e', J. A field is
/// [3 x nodes], m.
class StrainSpace {
 public:
  /// @param body       all of it is on this rank
  /// @param reference  [nodes] X, m
  /// @param stiffness  [regions]
  StrainSpace(const mesh::BodyPart& body, std::span<const Vector3> reference,
              std::span<const solid::StiffnessMatrix> stiffness);

  /// [6 x points] How many numbers a strain has.
  [[nodiscard]] Eigen::Index size() const { return 6 * points_; }

  /// Linear strain of a field u: the symmetric part of grad u.
  [[nodiscard]] Eigen::VectorXd linear(const Eigen::VectorXd& field) const;

  /// The rest of Green's strain of a field u: 1/2 (grad u)^T grad u.
  [[nodiscard]] Eigen::VectorXd quadratic(const Eigen::VectorXd& field) const;

  /// The transpose of `linear`: forces whose work on a field is the product of a strain with the field's, N. [3 x
  /// nodes]
  [[nodiscard]] Eigen::VectorXd forces(const Eigen::VectorXd& strain) const;

  /// H with q . H q = product of a strain with quadratic(sum q phi), symmetric. [strains][modes x modes]
  /// @param strains  [size() x strains]
  /// @param shapes   phi, [3 x nodes, modes]
  [[nodiscard]] std::vector<Eigen::MatrixXd> products(const Eigen::MatrixXd& strains,
                                                      const Eigen::MatrixXd& shapes) const;

  /// T with q . T q = mean square in the body of the rotation angle 1/2 |curl(sum q phi)|. [modes x modes]
  [[nodiscard]] Eigen::MatrixXd rotations(const Eigen::MatrixXd& shapes) const;

 private:
  /// One element: what its quadrature points need.
  struct Element {
    std::span<const Index> nodes;
    std::size_t region = 0;   ///< that it lies in
    Eigen::Index first = 0;   ///< number of its first point
    Eigen::MatrixXd slopes;   ///< [nodes, 3 x points] dN_a/dX at each point, 1/m
    Eigen::VectorXd volumes;  ///< [points] m3

    [[nodiscard]] Eigen::Index points() const { return volumes.size(); }
  };
  void for_each_element(const std::function<void(const Element& element)>& visit) const;

  /// A strain of a field, which `strain_of` finds from the field's gradient.
  [[nodiscard]] Eigen::VectorXd strain(
      const Eigen::VectorXd& field,
      const std::function<Eigen::Matrix3d(const Eigen::Matrix3d& gradient)>& strain_of) const;

  /// v sigma of the parts of strains that an element has, J. [6 x points, strains]
  [[nodiscard]] Eigen::MatrixXd stresses_of(const Eigen::Ref<const Eigen::MatrixXd>& strains,
                                            const Element& element) const;

  const mesh::BodyPart& body_;
  std::span<const Vector3> reference_;
  std::vector<Eigen::Matrix<double, 6, 6>> roots_;  ///< [regions] L
  Eigen::Index points_ = 0;
};

}  // namespace idiophone::eigenmodes
