#pragma once
// What a body does at once about a strain: it stretches statically, by all that its kept motions are not.

#include <Eigen/Core>

#include "idiophone/solids/modal_bodies/modal_basis.hpp"
#include "shifted_stiffness.hpp"
#include "strain_space.hpp"

namespace idiophone::eigenmodes {

/// Rigid motions that are orthonormal by the mass. [3 x nodes, motions]
/// @param rigid   linearly independent, [motions][3 x nodes]
/// @param masses  [3 x nodes] kg
[[nodiscard]] Eigen::MatrixXd orthonormal(const std::vector<std::vector<double>>& rigid, const Eigen::VectorXd& masses);

class StaticStretch {
 public:
  /// @param stiffness  of the body, with a shift far below the lowest mode where it can move rigidly, and without one
  ///                   where it cannot; must outlive this object, as must `space`
  /// @param rigid      rigid motions that nothing resists, [motions][3 x nodes]
  StaticStretch(const ShiftedStiffness& stiffness, const StrainSpace& space, const modal_bodies::ModalBasis& basis,
                const std::vector<std::vector<double>>& rigid);

  /// What remains of each strain b with the displacement w that makes it least, b + e(w). All w count that are
  /// orthogonal, by the mass, to the modes of the basis and to rigid motions. [size of the space, strains]
  [[nodiscard]] Eigen::MatrixXd remainders(const Eigen::MatrixXd& strains) const;

 private:
  const StrainSpace& space_;
  const ShiftedStiffness& stiffness_;
  Eigen::VectorXd masses_;  ///< [3 x nodes] kg
  Eigen::MatrixXd kept_;    ///< [3 x nodes, rigid motions and modes] orthonormal by the mass
};

}  // namespace idiophone::eigenmodes
