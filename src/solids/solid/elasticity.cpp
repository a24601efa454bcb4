#include "idiophone/solids/solid/elasticity.hpp"

#include <Eigen/LU>

namespace idiophone::solid {

namespace {

/// C along the material's own axes, by its inverse: E_i = S_i/E_i - sum of nu_ji S_j/E_j, 2 E_ij = S_ij/G_ij.
StiffnessMatrix own_stiffness(const scene::Orthotropy& constants) {
  const auto& [young, poisson, shear] = constants;
  StiffnessMatrix compliance = StiffnessMatrix::Zero();
  compliance.diagonal() << young.cwiseInverse(), 1 / shear[1], 1 / shear[2], 1 / shear[0];
  compliance(0, 1) = compliance(1, 0) = -poisson[0] / young[0];
  compliance(1, 2) = compliance(2, 1) = -poisson[1] / young[1];
  compliance(0, 2) = compliance(2, 0) = -poisson[2] / young[0];
  return compliance.inverse();
}

/// T of S' = T S, where the stress S' is S turned: S'_ij = R_ik R_jl S_kl.
StiffnessMatrix stress_turn(const Eigen::Matrix3d& turn) {
  StiffnessMatrix result;
  for (int p = 0; p < 6; ++p) {
    for (int q = 0; q < 6; ++q) {
      const auto [i, j] = direction_pairs[p];
      const auto [k, l] = direction_pairs[q];
      result(p, q) = turn(i, k) * turn(j, l) + (k == l ? 0.0 : turn(i, l) * turn(j, k));
    }
  }
  return result;
}

}  // namespace

Elasticity elasticity(const scene::Material& material, const Eigen::Matrix3d& axes, double factor) {
  if (material.orthotropy) {
    // By the virtual work of any strain, E = T^T E', and so C' = T C T^T.
    const StiffnessMatrix turn = stress_turn(axes);
    return AnisotropicElasticity{factor * turn * own_stiffness(*material.orthotropy) * turn.transpose()};
  }
  const double young = factor * material.young;
  const double poisson = material.poisson;
  return IsotropicElasticity{young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))};
}

StiffnessMatrix stiffness_matrix(const Elasticity& elasticity) {
  if (const auto* anisotropic = std::get_if<AnisotropicElasticity>(&elasticity)) {
    return anisotropic->stiffness;
  }
  StiffnessMatrix c = StiffnessMatrix::Zero();
  const auto& [lambda, mu] = std::get<IsotropicElasticity>(elasticity);
  c.topLeftCorner<3, 3>().setConstant(lambda);
  c.diagonal() += mu * Eigen::Vector<double, 6>(2, 2, 2, 1, 1, 1);
  return c;
}

}  // namespace idiophone::solid
