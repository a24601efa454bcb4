#include "idiophone/solids/solid/elasticity.hpp"

#include <Eigen/LU>
#include <numbers>

#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::solid {

namespace {

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

StiffnessMatrix turned(const StiffnessMatrix& stiffness, const Eigen::Matrix3d& axes, double factor) {
  // By the virtual work of any strain, E = T^T E', and so C' = T C T^T.
  const StiffnessMatrix turn = stress_turn(axes);
  return factor * turn * stiffness * turn.transpose();
}

Elasticity elasticity(const scene::Material& material, const Eigen::Matrix3d& axes, double factor) {
  if (!material.is_isotropic()) {
    const StiffnessMatrix own =
        material.crystal ? scene::stiffness_matrix(*material.crystal) : scene::stiffness_matrix(*material.orthotropy);
    return AnisotropicElasticity{turned(own, axes, factor)};
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

Eigen::Matrix3d stress_of(const Elasticity& elasticity, const Eigen::Matrix3d& strain) {
  Eigen::Vector<double, 6> e;
  for (int p = 0; p < 6; ++p) {
    e[p] = (p < 3 ? 1 : 2) * strain(direction_pairs[p][0], direction_pairs[p][1]);
  }
  const Eigen::Vector<double, 6> s = stiffness_matrix(elasticity) * e;
  Eigen::Matrix3d stress;
  for (int p = 0; p < 6; ++p) {
    const auto& [i, j] = direction_pairs[p];
    stress(i, j) = stress(j, i) = s[p];
  }
  return stress;
}

PackSymmetric strain_of(const Elasticity& elasticity, const Eigen::Matrix3d& stress) {
  Eigen::Vector<double, 6> s;
  for (int p = 0; p < 6; ++p) {
    s[p] = stress(direction_pairs[p][0], direction_pairs[p][1]);
  }
  const Eigen::Vector<double, 6> e = stiffness_matrix(elasticity).fullPivLu().solve(s);
  PackSymmetric strain;
  for (int p = 0; p < 6; ++p) {
    strain.at[p] = Pack{} + (p < 3 ? e[p] : e[p] / 2);
  }
  return strain;
}

double least_stiffness(const Elasticity& elasticity) {
  // With shears times the root of 2, the square of the six numbers is |E|^2.
  Eigen::Vector<double, 6> scale = Eigen::Vector<double, 6>::Ones();
  scale.tail<3>() *= std::numbers::sqrt2;
  return dense::eigenpairs(dense::Matrix6(scale.asDiagonal() * stiffness_matrix(elasticity) * scale.asDiagonal()))
      .values[0];
}

}  // namespace idiophone::solid
