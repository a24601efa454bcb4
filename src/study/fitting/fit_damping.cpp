#include "fit_damping.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::fitting {

namespace {

/// Relative rates of loss factor, mass and stiffness damping of 1, [decays x 3].
Eigen::MatrixX3d relative_rates(const std::vector<Decay>& decays) {
  Eigen::MatrixX3d rates(decays.size(), 3);
  for (std::size_t i = 0; i < decays.size(); ++i) {
    const double w = 2 * std::numbers::pi * decays[i].frequency;
    rates.row(static_cast<Eigen::Index>(i)) =
        Eigen::RowVector3d(w, 1, w * w) * decays[i].decay_time / (2 * std::log(1000.0));
  }
  return rates;
}

/// Least squares with all rates near 1, by trying every choice of columns.
Vector3 non_negative(const Eigen::MatrixX3d& rates) {
  const auto most = std::max<std::size_t>(1, static_cast<std::size_t>(rates.rows()) / 2);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(rates.rows());
  Vector3 best = Vector3::Zero();
  double smallest = ones.squaredNorm();
  for (unsigned choice = 1; choice < 8; ++choice) {
    std::vector<int> columns;
    for (int column = 0; column < 3; ++column) {
      if (((choice >> column) & 1U) != 0) {
        columns.push_back(column);
      }
    }
    if (columns.size() > most) {
      continue;
    }
    const Eigen::MatrixXd chosen = rates(Eigen::all, columns);
    const Eigen::VectorXd scale = chosen.colwise().norm().cwiseInverse();
    const Eigen::VectorXd values = scale.cwiseProduct(dense::least_squares(chosen * scale.asDiagonal(), ones));
    const double rest = (chosen * values - ones).squaredNorm();
    constexpr double better = 1 - 1e-9;
    if (values.minCoeff() >= 0 && rest < better * smallest) {
      smallest = rest;
      best.setZero();
      best(columns) = values;
    }
  }
  return best;
}

}  // namespace

std::array<double, 2> band_around(const std::vector<Decay>& decays) {
  std::array<double, 2> band = scene::LossFactor().band;
  for (const Decay& decay : decays) {
    band = {std::min(band[0], decay.frequency / 2), std::max(band[1], 2 * decay.frequency)};
  }
  return band;
}

std::optional<scene::Damping> fit_damping(const std::vector<Decay>& decays) {
  if (decays.empty()) {
    return {};
  }
  const Vector3 values = non_negative(relative_rates(decays));
  scene::Damping damping{.mass = values[1], .stiffness = values[2]};
  if (values[0] > 0) {
    scene::LossFactor loss;
    loss.value = values[0];
    loss.band = band_around(decays);
    damping.loss = loss;
  }
  return damping;
}

double squares_of(const scene::Damping& damping, const std::vector<Decay>& decays) {
  const Vector3 values(damping.loss ? damping.loss->value : 0.0, damping.mass, damping.stiffness);
  return ((relative_rates(decays) * values).array() - 1).square().sum();
}

}  // namespace idiophone::fitting
