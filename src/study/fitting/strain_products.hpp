#pragma once
// How modes strain their body, as the stiffness matrix sees it.

#include <Eigen/Core>
#include <array>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/elasticity.hpp"

namespace idiophone::fitting {

/// Integrals of products of the strains of some shapes over their body, by the quadrature of the internal force. They
/// give the stiffness of the body in the space of the shapes for any material.
class StrainProducts {
 public:
  StrainProducts() = default;
  /// @param part    of one body, all of it on this rank
  /// @param shapes  [3 x nodes, shapes] m
  StrainProducts(const mesh::Part& part, const Eigen::MatrixXd& shapes);

  /// Q_pq, the integral of E_p E_q, m3, with the strain E of the sum of all shapes times their factors, in the order of
  /// solid::StiffnessMatrix. For a mode of unit modal mass C : Q = w^2 (kg m2) for every stiffness C whose mode it is,
  /// and dC : Q = d(w^2) for small changes of C (Hellmann and Feynman).
  [[nodiscard]] solid::StiffnessMatrix of(const Eigen::VectorXd& factors) const;

  /// x_i^T K x_j of the shapes x, for the stiffness matrix K of a body of this material: the integral of C : E_i E_j.
  /// [shapes x shapes], N m
  [[nodiscard]] Eigen::MatrixXd energies(const solid::StiffnessMatrix& stiffness) const;

 private:
  std::array<Eigen::MatrixXd, 21> products_;  ///< the integrals of E_p E_q + E_q E_p, p <= q; [shapes x shapes]
};

}  // namespace idiophone::fitting
