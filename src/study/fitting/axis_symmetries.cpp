#include "axis_symmetries.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numbers>

#include "idiophone/solids/solid/elasticity.hpp"

namespace idiophone::fitting {

namespace {

using Rotations = std::vector<Eigen::Matrix3d>;

/// The 24 rotations of a cube: permutations of its axes with signs.
Rotations rotations_of_cube() {
  Rotations all;
  std::array<int, 3> order = {0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
      for (int axis = 0; axis < 3; ++axis) {
        rotation(order.at(axis), axis) = (signs >> axis & 1) != 0 ? -1 : 1;
      }
      if (rotation.determinant() > 0) {
        all.push_back(rotation);
      }
    }
  } while (std::ranges::next_permutation(order).found);
  return all;
}

/// Sixths and thirds of a turn about z, and the same with a half turn about x.
Rotations rotations_of_hexagon() {
  Rotations all;
  for (const int sixth : {1, 2, 4, 5}) {
    all.push_back(Eigen::AngleAxisd(sixth * std::numbers::pi / 3, Vector3::UnitZ()).toRotationMatrix());
    all.push_back(all.back() * Vector3(1, -1, -1).asDiagonal());
  }
  return all;
}

solid::StiffnessMatrix stiffness_of(const scene::Material& material, const Eigen::Matrix3d& axes) {
  return solid::stiffness_matrix(solid::elasticity(material, axes));
}

bool are_equal(const solid::StiffnessMatrix& a, const solid::StiffnessMatrix& b) {
  constexpr double negligible = 1e-6;
  return (a - b).norm() < negligible * a.norm();
}

}  // namespace

Rotations symmetries_of(const scene::Material& material) {
  Rotations all = rotations_of_cube();
  std::ranges::copy(rotations_of_hexagon(), std::back_inserter(all));
  const solid::StiffnessMatrix own = stiffness_of(material, Eigen::Matrix3d::Identity());
  std::erase_if(all,
                [&](const Eigen::Matrix3d& rotation) { return !are_equal(own, stiffness_of(material, rotation)); });
  return all;
}

Rotations symmetries_of_box(const Eigen::Matrix3d& axes, const Vector3& extents) {
  constexpr double negligible = 0.01;
  Rotations all;
  for (const Eigen::Matrix3d& rotation : rotations_of_cube()) {
    if (((rotation.cwiseAbs() * extents).cwiseQuotient(extents).array() - 1).abs().maxCoeff() < negligible) {
      all.push_back(axes * rotation * axes.transpose());
    }
  }
  return all;
}

Eigen::Matrix3d smallest_turn(const Eigen::Matrix3d& rotation, const Rotations& symmetries) {
  Eigen::Matrix3d least = rotation;
  for (const Eigen::Matrix3d& symmetry : symmetries) {
    constexpr double clearly = 1e-9;  // of equal ones, the first
    if ((rotation * symmetry).trace() > least.trace() + clearly) {
      least = rotation * symmetry;
    }
  }
  return least;
}

double angle_of(const Eigen::Matrix3d& rotation) {
  return Eigen::AngleAxisd(rotation).angle() * 180 / std::numbers::pi;
}

bool is_round_about(int axis, const TurnedMaterial& material) {
  constexpr double any = 50.0;  // degrees; no crystal has a symmetry by such an angle
  TurnedMaterial other = material;
  other.turns[axis] += any;
  return are_equal(stiffness_of(material, material.turn()), stiffness_of(other, other.turn()));
}

}  // namespace idiophone::fitting
