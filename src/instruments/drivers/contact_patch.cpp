#include "contact_patch.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace idiophone::drivers {

std::vector<Vector3> ContactPatch::points() const {
  constexpr double least_reach = 1e-3;  // m; modes below 20 kHz are even over less
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  std::vector<Vector3> reaches;
  for (int k = 0; k < 3; ++k) {
    if (axes.eigenvalues()[k] > least_reach * least_reach) {
      reaches.emplace_back(std::sqrt(axes.eigenvalues()[k]) * axes.eigenvectors().col(k));
    }
  }
  if (reaches.empty()) {
    return {middle};
  }
  std::vector<Vector3> points;
  const double stretch = std::sqrt(static_cast<double>(reaches.size()));  // two of 2 n points are on an axis
  for (const Vector3& reach : reaches) {
    points.emplace_back(middle + stretch * reach);
    points.emplace_back(middle - stretch * reach);
  }
  return points;
}

void MeanPatch::add(const ContactPatch& patch, double weight) {
  places_ += weight * patch.middle;
  squares_ += weight * (patch.spread + patch.middle * patch.middle.transpose());
  weights_ += weight;
}

ContactPatch MeanPatch::mean() const {
  const Vector3 middle = places_ / weights_;
  return {.middle = middle, .spread = squares_ / weights_ - middle * middle.transpose()};
}

}  // namespace idiophone::drivers
