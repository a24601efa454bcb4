#include "idiophone/solid/elasticity.hpp"

namespace idiophone::solid {

Elasticity elasticity(const scene::Material& material, double factor) {
  const double young = factor * material.young;
  const double poisson = material.poisson;
  return IsotropicElasticity{young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))};
}

Eigen::Matrix<double, 6, 6> stiffness_matrix(const Elasticity& elasticity) {
  Eigen::Matrix<double, 6, 6> c = Eigen::Matrix<double, 6, 6>::Zero();
  const auto& [lambda, mu] = std::get<IsotropicElasticity>(elasticity);
  c.topLeftCorner<3, 3>().setConstant(lambda);
  c.diagonal() += mu * Eigen::Vector<double, 6>(2, 2, 2, 1, 1, 1);
  return c;
}

}  // namespace idiophone::solid
