#pragma once
// A tetrahedron with straight edges: its volume, its barycentric coordinates and its planes.

#include <Eigen/Geometry>
#include <array>

#include "idiophone/foundation/types.hpp"
#include "idiophone/solids/contact/rigid_shape.hpp"

namespace idiophone::contact {

struct Tetrahedron {
  std::array<Vector3, 4> corners;    ///< m
  std::array<Vector3, 4> gradients;  ///< of the barycentric coordinates, 1/m
  double volume = 0.0;               ///< m3; negative where it is turned inside out

  explicit Tetrahedron(const std::array<Vector3, 4>& at) : corners(at) {
    const Vector3 a = at[1] - at[0];
    const Vector3 b = at[2] - at[0];
    const Vector3 c = at[3] - at[0];
    const double six_volumes = a.dot(b.cross(c));
    volume = six_volumes / 6;
    gradients[1] = b.cross(c) / six_volumes;
    gradients[2] = c.cross(a) / six_volumes;
    gradients[3] = a.cross(b) / six_volumes;
    gradients[0] = -(gradients[1] + gradients[2] + gradients[3]);
  }

  /// Barycentric coordinates of a point.
  [[nodiscard]] Eigen::Vector4d coordinates(const Vector3& x) const {
    const Vector3 arm = x - corners[0];
    const Eigen::Vector3d rest(gradients[1].dot(arm), gradients[2].dot(arm), gradients[3].dot(arm));
    return {1 - rest.sum(), rest[0], rest[1], rest[2]};
  }

  /// Of the face opposite a corner.
  [[nodiscard]] Plane plane(std::size_t corner) const {
    return {-gradients[corner].normalized(), corners[(corner + 1) % 4]};
  }

  /// The corners of the face opposite a corner, in order around its outward normal.
  [[nodiscard]] std::array<Vector3, 3> face(std::size_t corner) const {
    static constexpr std::array<std::array<std::size_t, 3>, 4> order{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
    return {corners[order[corner][0]], corners[order[corner][1]], corners[order[corner][2]]};
  }
};

}  // namespace idiophone::contact
