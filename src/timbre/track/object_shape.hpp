#pragma once
// The straight ways of sound past, into and by way of a solid with flat faces.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::timbre {

/// A closed surface of triangles, which can be put anywhere. Triangles in one plane are one face.
class ObjectShape {
 public:
  /// A straight way meets a face.
  struct Meeting {
    std::size_t face = 0;
    double cosine = 1.0;  ///< of the angle off its normal
    Vector3 point;        ///< m
  };
  using Triangle = std::array<Vector3, 3>;

  /// @param triangles  corners in its own coordinates, m; normals by the right-hand rule point outwards
  explicit ObjectShape(const std::vector<Triangle>& triangles);

  /// @param size  lengths of its edges, m; its origin is its centre. Faces 0 and 1 are those of the highest and the
  ///              lowest x, and so on
  [[nodiscard]] static ObjectShape box(const Vector3& size);

  /// @param origin  m
  /// @param axes    unit vectors, in the columns
  void place(const Vector3& origin, const Eigen::Matrix3d& axes);

  /// Whether a place is inside; on a face or an edge it is not.
  [[nodiscard]] bool contains(const Vector3& place) const;

  /// Where a way enters it, or leaves it if it begins inside; none if it stays outside or inside. What only touches it
  /// stays outside.
  [[nodiscard]] std::optional<Meeting> crossing(const Vector3& from, const Vector3& to) const;

  /// The face that mirrors a source to a receiver, both outside, with the solid nowhere in the way. If there are
  /// several, the one of the shortest way.
  [[nodiscard]] std::optional<Meeting> reflection(const Vector3& from, const Vector3& to) const;

  /// The mirror image of a place behind a face.
  [[nodiscard]] Vector3 mirrored(const Vector3& place, std::size_t face) const;
  [[nodiscard]] Vector3 mirrored_direction(const Vector3& direction, std::size_t face) const;

 private:
  struct Face {
    Vector3 normal;       // unit vector
    double height = 0.0;  // normal times its points, m
    std::vector<Triangle> triangles;
  };
  struct Hit {
    double part = 0.0;  // of the way
    std::size_t face = 0;
  };
  void add(const Triangle& triangle);
  [[nodiscard]] Vector3 own(const Vector3& place) const { return axes_.transpose() * (place - origin_); }
  [[nodiscard]] bool holds(const Vector3& own_place) const;
  /// Where a way in own coordinates goes through faces, in its order.
  [[nodiscard]] std::vector<Hit> hits(const Vector3& begin, const Vector3& end) const;

  std::vector<Face> faces_;
  Vector3 middle_ = Vector3::Zero();  // of a sphere around it, in own coordinates, m
  double radius_ = 0.0;               // of that sphere, m
  Vector3 origin_ = Vector3::Zero();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
};

}  // namespace idiophone::timbre
