#include "contact_patch.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace idiophone::drivers {

std::vector<Vector3> ContactPatch::points() const {
  constexpr double least_reach = 1e-3;  // m; modes below 20 kHz are even over less
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  if (axes.eigenvalues().maxCoeff() < least_reach * least_reach) {
    return {middle};
  }
  // The columns of the root do not depend on the choice of axes, which a round patch leaves open.
  const Eigen::Matrix3d root =
      axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() * axes.eigenvectors().transpose();
  std::vector<Vector3> points;
  for (int k = 0; k < 3; ++k) {
    const Vector3 reach = std::sqrt(3.0) * root.col(k);  // a third of the points are on it
    points.emplace_back(middle + reach);
    points.emplace_back(middle - reach);
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
