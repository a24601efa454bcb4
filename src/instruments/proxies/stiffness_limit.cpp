#include "stiffness_limit.hpp"

#include <algorithm>
#include <utility>

namespace idiophone::proxies {

StiffnessLimit::StiffnessLimit(const Lattice& lattice) : lattice_(lattice) {
  const FrequencyBounds plain =
      frequency_bounds(lattice.mesh().nodes, lattice.springs(), lattice.masses(), lattice.pinned(), 0);
  largest_square_ = std::ranges::max(plain.squares);
}

FrequencyBounds StiffnessLimit::bounds(const Eigen::VectorXd& stiffness) const {
  std::vector<Spring> springs = lattice_.springs();
  for (std::size_t s = 0; s < springs.size(); ++s) {
    springs[s].stiffness = stiffness[static_cast<Eigen::Index>(s)];
  }
  return frequency_bounds(lattice_.mesh().nodes, springs, lattice_.masses(), lattice_.pinned(), enough_rounds);
}

Misfit StiffnessLimit::excess(const Eigen::VectorXd& stiffness) const {
  constexpr double near = 0.95;    // of the limit: a fit comes to rest a little above
  constexpr double weight = 0.03;  // of a square that is twice the limit, over a flexibility that errs by 1
  const FrequencyBounds bounds = this->bounds(stiffness);
  std::vector<Eigen::Index> residual_of(bounds.squares.size(), -1);
  std::vector<double> values;
  for (std::size_t i = 0; i < bounds.squares.size(); ++i) {
    if (const double beyond = bounds.squares[i] / largest_square_ - near; beyond > 0.0) {
      residual_of[i] = std::ssize(values);
      values.push_back(weight * beyond);
    }
  }
  Misfit misfit{.values = Eigen::VectorXd::Map(values.data(), std::ssize(values)),
                .slopes = Eigen::MatrixXd::Zero(stiffness.size(), std::ssize(values))};
  for (Eigen::Index s = 0; s < stiffness.size(); ++s) {
    const Spring& spring = lattice_.springs()[s];
    const Vector3 n = (lattice_.mesh().nodes[spring.b] - lattice_.mesh().nodes[spring.a]).normalized();
    for (const auto& [mass, other] : {std::pair(spring.a, spring.b), std::pair(spring.b, spring.a)}) {
      if (residual_of[mass] >= 0) {
        const double share = 1.0 + bounds.weights[other] / bounds.weights[mass], along = n.dot(bounds.directions[mass]);
        misfit.slopes(s, residual_of[mass]) =
            weight * share * stiffness[s] * along * along / (lattice_.masses()[mass] * largest_square_);
      }
    }
  }
  return misfit;
}

Eigen::VectorXd StiffnessLimit::held(Eigen::VectorXd stiffness) const {
  constexpr int most_rounds = 50;
  for (int round = 0; round < most_rounds; ++round) {
    const FrequencyBounds bounds = this->bounds(stiffness);
    if (std::ranges::max(bounds.squares) <= largest_square_) {
      return stiffness;
    }
    for (Eigen::Index s = 0; s < stiffness.size(); ++s) {
      const Spring& spring = lattice_.springs()[s];
      const double larger = std::max(bounds.squares[spring.a], bounds.squares[spring.b]);
      stiffness[s] *= std::min(largest_square_ / larger, 1.0);
    }
  }
  return stiffness * largest_square_ / std::ranges::max(bounds(stiffness).squares);
}

}  // namespace idiophone::proxies
