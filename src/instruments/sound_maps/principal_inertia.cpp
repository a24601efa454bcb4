#include "principal_inertia.hpp"

#include <Eigen/Eigenvalues>

#include "idiophone/foundation/inertia_tensor.hpp"

namespace idiophone::sound_maps {

PrincipalInertia principal_inertia(const SoundMap& map) {
  double volume = 0.0;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // integral of x x^T over the volume, m5
  for (const auto& [first, middle, last] : map.triangles) {
    const Vector3 a = map.vertices[first] - map.centre;
    const Vector3 b = map.vertices[middle] - map.centre;
    const Vector3 c = map.vertices[last] - map.centre;
    const double share = a.dot(b.cross(c)) / 6.0;
    const Vector3 sum = a + b + c;
    volume += share;
    second += share / 20.0 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  second *= map.mass / volume;
  const Eigen::Matrix3d inertia = inertia_tensor(second);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved(inertia);
  Eigen::Matrix3d axes = solved.eigenvectors();
  if (axes.determinant() < 0.0) {
    axes.col(0) = -axes.col(0);
  }
  return {.moments = solved.eigenvalues(), .axes = Eigen::Quaterniond(axes).normalized()};
}

}  // namespace idiophone::sound_maps
