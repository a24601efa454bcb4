#include "idiophone/solids/eigenmodes/is_rigid_motion.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "idiophone/foundation/types.hpp"

namespace idiophone::eigenmodes {

bool is_rigid_motion(const Eigen::Ref<const Eigen::Matrix3Xd>& places,
                     const Eigen::Ref<const Eigen::Matrix3Xd>& displacements) {
  constexpr double largest_bend = 0.1;  // of the largest displacement
  const auto count = static_cast<double>(places.cols());
  const Vector3 middle = places.rowwise().sum() / count;
  const Vector3 mean = displacements.rowwise().sum() / count;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Vector3 moment = Vector3::Zero();
  for (Eigen::Index n = 0; n < places.cols(); ++n) {
    const Vector3 arm = places.col(n) - middle;
    const Vector3 way = displacements.col(n);
    inertia += arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose();
    moment += arm.cross(way);
  }
  const Vector3 turn = inertia.inverse() * moment;
  const Eigen::Matrix3Xd arms = places.colwise() - middle;
  const Eigen::Matrix3Xd bend = (displacements - arms.colwise().cross(-turn)).colwise() - mean;
  // The mean over the points would not do: most of them can be at the heavy end of a cantilever, which hardly bends.
  return bend.colwise().squaredNorm().maxCoeff() <
         largest_bend * largest_bend * displacements.colwise().squaredNorm().maxCoeff();
}

}  // namespace idiophone::eigenmodes
