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
/// [3 x nodes], m; several are columns.
class StrainSpace {
 public:
  /// @param body       all of it is on this rank
  /// @param reference  [nodes] X, m
  /// @param stiffness  [regions]
  StrainSpace(const mesh::BodyPart& body, std::span<const Vector3> reference,
              std::span<const solid::StiffnessMatrix> stiffness);

  /// [6 x points] How many numbers a strain has.
  [[nodiscard]] Eigen::Index size() const { return 6 * points_; }

  /// Linear strains of fields u: the symmetric part of grad u. [size() x fields]
  [[nodiscard]] Eigen::MatrixXd linear(const Eigen::Ref<const Eigen::MatrixXd>& fields) const;

  /// The rest of Green's strains of fields u: 1/2 (grad u)^T grad u. [size() x fields]
  [[nodiscard]] Eigen::MatrixXd quadratic(const Eigen::Ref<const Eigen::MatrixXd>& fields) const;

  /// The transpose of `linear`: forces whose work on a field is the product of a strain with the field's, N. [3 x
  /// nodes, strains]
  [[nodiscard]] Eigen::MatrixXd forces(const Eigen::Ref<const Eigen::MatrixXd>& strains) const;

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

  /// Strains of fields, which `strain_of` finds from a field's gradient.
  template <class StrainOf>
  [[nodiscard]] Eigen::MatrixXd strains(const Eigen::Ref<const Eigen::MatrixXd>& fields,
                                        const StrainOf& strain_of) const;

  /// v sigma of the parts of strains that an element has, J. [6 x points, strains]
  [[nodiscard]] Eigen::MatrixXd stresses_of(const Eigen::Ref<const Eigen::MatrixXd>& strains,
                                            const Element& element) const;

  const mesh::BodyPart& body_;
  std::span<const Vector3> reference_;
  std::vector<Eigen::Matrix<double, 6, 6>> roots_;  ///< [regions] L
  Eigen::Index points_ = 0;
};

}  // namespace idiophone::eigenmodes
