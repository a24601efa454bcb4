#include "frequency_bound.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace idiophone::proxies {

namespace {

using Tensor = Eigen::Matrix3d;

/// How a spring pulls: along it, and across it under tension, N/m.
Tensor tensor_of(const Spring& spring, std::span<const Vector3> nodes) {
  const Vector3 way = nodes[spring.b] - nodes[spring.a], direction = way.normalized();
  const double across = std::max(spring.tension / way.norm(), 0.0);
  return (spring.stiffness - across) * direction * direction.transpose() + across * Tensor::Identity();
}

FrequencyBounds bounds_with(std::vector<double> weights, std::span<const Spring> springs,
                            const std::vector<Tensor>& tensors, std::span<const double> masses) {
  std::vector<Tensor> stiffness(masses.size(), Tensor::Zero());
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const Spring& spring = springs[s];
    for (const auto& [mass, other] : {std::pair(spring.a, spring.b), std::pair(spring.b, spring.a)}) {
      if (weights[mass] > 0.0) {
        stiffness[mass] += (1.0 + weights[other] / weights[mass]) * tensors[s];
      }
    }
  }
  FrequencyBounds bounds{.squares = std::vector<double>(masses.size()),
                         .weights = std::move(weights),
                         .directions = std::vector<Vector3>(masses.size(), Vector3::UnitX())};
  for (std::size_t i = 0; i < masses.size(); ++i) {
    if (bounds.weights[i] > 0.0) {
      const Eigen::SelfAdjointEigenSolver<Tensor> solver(stiffness[i]);
      bounds.squares[i] = solver.eigenvalues()[2] / masses[i];
      bounds.directions[i] = solver.eigenvectors().col(2);
    }
  }
  return bounds;
}

/// Larger where the bound is above the mean.
std::vector<double> next_weights(const FrequencyBounds& bounds) {
  constexpr double gain = 0.25;  // more makes the bounds of neighbours swing
  const auto moving = static_cast<double>(std::ranges::count_if(bounds.weights, [](double v) { return v > 0.0; }));
  const double mean = std::accumulate(bounds.squares.begin(), bounds.squares.end(), 0.0) / moving;
  std::vector<double> weights;
  for (std::size_t i = 0; i < bounds.weights.size(); ++i) {
    constexpr double least = 1e-9;  // a mass without stiff springs keeps some weight
    weights.push_back(bounds.weights[i] * std::pow(std::max(bounds.squares[i] / mean, least), gain));
  }
  return weights;
}

}  // namespace

FrequencyBounds frequency_bounds(std::span<const Vector3> nodes, std::span<const Spring> springs,
                                 std::span<const double> masses, const std::vector<bool>& pinned, int rounds) {
  std::vector<Tensor> tensors;
  for (const Spring& spring : springs) {
    tensors.push_back(tensor_of(spring, nodes));
  }
  std::vector<double> equal;
  equal.reserve(pinned.size());
  for (const bool is_pinned : pinned) {
    equal.push_back(is_pinned ? 0.0 : 1.0);
  }
  FrequencyBounds best = bounds_with(std::move(equal), springs, tensors, masses), present = best;
  for (int round = 0; round < rounds; ++round) {
    present = bounds_with(next_weights(present), springs, tensors, masses);
    if (std::ranges::max(present.squares) < std::ranges::max(best.squares)) {
      best = present;
    }
  }
  return best;
}

}  // namespace idiophone::proxies
