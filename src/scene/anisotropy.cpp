#include "idiophone/scene/anisotropy.hpp"

#include <Eigen/LU>
#include <numbers>

#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/scene/material.hpp"

namespace idiophone::scene {

// By its inverse: E_i = S_i/E_i - sum of nu_ji S_j/E_j, 2 E_ij = S_ij/G_ij.
StiffnessMatrix stiffness_matrix(const Orthotropy& constants) {
  const auto& [young, poisson, shear] = constants;
  StiffnessMatrix compliance = StiffnessMatrix::Zero();
  compliance.diagonal() << young.cwiseInverse(), 1 / shear[1], 1 / shear[2], 1 / shear[0];
  compliance(0, 1) = compliance(1, 0) = -poisson[0] / young[0];
  compliance(1, 2) = compliance(2, 1) = -poisson[1] / young[1];
  compliance(0, 2) = compliance(2, 0) = -poisson[2] / young[0];
  return compliance.inverse();
}

std::optional<Orthotropy> constants_along_axes(const Material& material) {
  if (!material.crystal) {
    return material.orthotropy;
  }
  const StiffnessMatrix compliance = stiffness_matrix(*material.crystal).inverse();
  const Eigen::Vector<double, 6> moduli = compliance.diagonal().cwiseInverse();
  return Orthotropy{
      .young = moduli.head<3>(),
      .poisson = {-compliance(0, 1) * moduli[0], -compliance(1, 2) * moduli[1], -compliance(0, 2) * moduli[0]},
      .shear = {moduli[5], moduli[3], moduli[4]}};
}

Eigen::Vector<double, 6> kelvin_moduli(const StiffnessMatrix& stiffness) {
  // With shear strains and stresses times sqrt(2), C maps unit vectors as the tensor maps unit tensors.
  Eigen::Vector<double, 6> scale;
  scale << 1, 1, 1, Eigen::Vector3d::Constant(std::numbers::sqrt2);
  return dense::eigenpairs(StiffnessMatrix(scale.asDiagonal() * stiffness * scale.asDiagonal())).values;
}

}  // namespace idiophone::scene
