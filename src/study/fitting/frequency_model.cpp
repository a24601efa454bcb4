#include "frequency_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/study/partials/compare.hpp"

namespace idiophone::fitting {

namespace {

constexpr double inseparable = 0.5;  // cents between the modes of a multiplet
const double cents_per_ratio = 1200 / std::numbers::ln2;

std::vector<Multiplet> multiplets_of(const std::vector<StrainedMode>& modes) {
  std::vector<Multiplet> multiplets;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (m == 0 || partials::cents(modes[m].frequency, modes[m - 1].frequency) > inseparable) {
      multiplets.push_back({.first = static_cast<int>(m)});
    }
    Multiplet& last = multiplets.back();
    ++last.count;
    last.square += std::pow(2 * std::numbers::pi * modes[m].frequency, 2);
    last.strain += modes[m].strain;
  }
  for (Multiplet& multiplet : multiplets) {
    multiplet.square /= multiplet.count;
    multiplet.strain /= multiplet.count;
  }
  return multiplets;
}

}  // namespace

FrequencyModel::FrequencyModel(const std::vector<StrainedMode>& modes, const TurnedMaterial& material,
                               Eigen::Matrix3d axes)
    : axes_(std::move(axes)), stiffness_(stiffness(material)), multiplets_(multiplets_of(modes)) {}

solid::StiffnessMatrix FrequencyModel::stiffness(const TurnedMaterial& material) const {
  return solid::stiffness_matrix(solid::elasticity(material, axes_of(material)));
}

Eigen::VectorXd FrequencyModel::frequencies(const TurnedMaterial& material) const {
  const solid::StiffnessMatrix change = stiffness(material) - stiffness_;
  Eigen::VectorXd values(multiplets_.size());
  std::ranges::transform(multiplets_, values.begin(), [&](const Multiplet& multiplet) {
    const double square = multiplet.square + change.cwiseProduct(multiplet.strain).sum();
    constexpr double least = 1e-3;  // of w^2, far from where the first order holds
    return std::sqrt(std::max(square, least * multiplet.square)) / (2 * std::numbers::pi);
  });
  return values;
}

Eigen::MatrixXd FrequencyModel::cents_slopes(const ElasticConstants& constants, const TurnedMaterial& material) const {
  const Eigen::VectorXd squares = (2 * std::numbers::pi * frequencies(material)).array().square();
  const Eigen::VectorXd point = unknowns(constants, material);
  Eigen::MatrixXd slopes(multiplets_.size(), constants.size());
  constexpr double h = 1e-5;  // for central differences of C, exact to some 1e-10
  for (Eigen::Index k = 0; k < slopes.cols(); ++k) {
    const Eigen::VectorXd change = h * Eigen::VectorXd::Unit(point.size(), k);
    const solid::StiffnessMatrix slope = (stiffness(with_unknowns(constants, material, point + change)) -
                                          stiffness(with_unknowns(constants, material, point - change))) /
                                         (2 * h);
    for (Eigen::Index m = 0; m < slopes.rows(); ++m) {
      slopes(m, k) = cents_per_ratio * slope.cwiseProduct(multiplets_[m].strain).sum() / (2 * squares[m]);
    }
  }
  return slopes;
}

bool is_stable(const scene::Material& material) {
  const solid::StiffnessMatrix stiffness = solid::stiffness_matrix(solid::elasticity(material));
  if (!stiffness.allFinite()) {
    return false;
  }
  const dense::Vector6 stiffnesses = dense::eigenpairs(stiffness).values;
  constexpr double least = 1e-4;  // as of Poisson's ratio 0.49985
  return stiffnesses[0] > least * stiffnesses[5];
}

}  // namespace idiophone::fitting
