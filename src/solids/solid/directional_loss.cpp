#include "idiophone/solids/solid/directional_loss.hpp"

#include <Eigen/Cholesky>

#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::solid {

namespace {

StiffnessMatrix whole_stiffness(const OrientedMaterial& oriented) {
  return stiffness_matrix(elasticity(oriented.material, oriented.axes));
}

/// D along the material's axes, in StiffnessMatrix's order.
Eigen::Vector<double, 6> roots_of_shares(const scene::LossFactor& loss) {
  const auto& [young, shear] = *loss.directions;
  const Eigen::Vector<double, 6> all(young[0], young[1], young[2], shear[1], shear[2], shear[0]);
  return (all / loss.value).cwiseSqrt();
}

/// C_r of a material with loss factors by direction.
StiffnessMatrix relaxing_stiffness(const OrientedMaterial& oriented) {
  const StiffnessMatrix own = scene::stiffness_matrix(*oriented.material.orthotropy);
  const StiffnessMatrix shared = roots_of_shares(*oriented.material.damping.loss).asDiagonal() * own;
  return turned(shared.transpose() * own.ldlt().solve(shared), oriented.axes);
}

}  // namespace

Elasticity relaxing_elasticity(const OrientedMaterial& oriented) {
  if (!oriented.material.damping.has_directional_loss()) {
    return elasticity(oriented.material, oriented.axes);
  }
  return AnisotropicElasticity{relaxing_stiffness(oriented)};
}

Elasticity elasticity_at(const OrientedMaterial& oriented, double modulus) {
  if (!oriented.material.damping.has_directional_loss()) {
    return elasticity(oriented.material, oriented.axes, modulus);
  }
  const StiffnessMatrix stiffness = whole_stiffness(oriented) + (modulus - 1) * relaxing_stiffness(oriented);
  if (scene::kelvin_moduli(stiffness)[0] <= 0) {
    throw deck::DeckError(oriented.material.damping.loss->where,
                          "these losses would leave the material no stiffness at rest: make them smaller, the band "
                          "narrower, or the directions more alike");
  }
  return AnisotropicElasticity{stiffness};
}

AnisotropicElasticity relaxing_strain(const OrientedMaterial& oriented) {
  StiffnessMatrix map = whole_stiffness(oriented).ldlt().solve(relaxing_stiffness(oriented));
  map.bottomRows<3>() /= 2;  // of shears, from 2 E_ij to E_ij
  return {map};
}

double largest_relaxing_share(const OrientedMaterial& oriented) {
  if (!oriented.material.damping.has_directional_loss()) {
    return 1.0;
  }
  const Eigen::LLT<StiffnessMatrix> whole(whole_stiffness(oriented));
  StiffnessMatrix share = whole.matrixL().solve(relaxing_stiffness(oriented));
  share = whole.matrixL().solve(StiffnessMatrix(share.transpose()));
  return dense::eigenpairs(dense::Matrix6(share)).values[5];
}

}  // namespace idiophone::solid
