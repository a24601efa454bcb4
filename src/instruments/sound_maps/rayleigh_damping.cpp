#include "rayleigh_damping.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace idiophone::sound_maps {

std::optional<RayleighDamping> rayleigh_damping(const SoundMap& map) {
  constexpr double largest_error = 0.01;
  const auto modes = static_cast<Eigen::Index>(map.modes());
  if (modes < 2) {
    return std::nullopt;
  }
  const double highest = 2.0 * std::numbers::pi * map.frequency.back();  // keeps both columns of one size
  Eigen::MatrixX2d rows(modes, 2);
  for (Eigen::Index mode = 0; mode < modes; ++mode) {
    const auto index = static_cast<std::size_t>(mode);
    if (!(map.material_decay[index] > 0.0)) {
      return std::nullopt;
    }
    const double ratio = map.frequency[index] / map.frequency.back();
    rows.row(mode) << 0.5 / map.material_decay[index], 0.5 * ratio * ratio / map.material_decay[index];
  }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(modes);
  const Eigen::Vector2d found = rows.colPivHouseholderQr().solve(ones);
  const Eigen::Vector2d positive = found.cwiseMax(0.0);  // rounding may leave less than 0
  if (!((rows * positive - ones).cwiseAbs().maxCoeff() < largest_error)) {
    return std::nullopt;
  }
  return RayleighDamping{.alpha = positive[0], .beta = positive[1] / (highest * highest)};
}

}  // namespace idiophone::sound_maps
