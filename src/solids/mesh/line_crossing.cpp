#include "idiophone/solids/mesh/line_crossing.hpp"

#include <Eigen/Geometry>

namespace idiophone::mesh {

std::optional<double> line_crossing(const TrianglePoints& corners, const Vector3& from, const Vector3& direction,
                                    double slack) {
  const Vector3 first = corners[1] - corners[0], second = corners[2] - corners[0];
  const Vector3 across = direction.cross(second);
  const double determinant = first.dot(across);
  if (determinant == 0.0) {
    return {};
  }
  const Vector3 offset = from - corners[0];
  const double u = offset.dot(across) / determinant;
  const Vector3 other = offset.cross(first);
  const double v = direction.dot(other) / determinant;
  if (u < -slack || v < -slack || u + v > 1.0 + slack) {
    return {};
  }
  return second.dot(other) / determinant;
}

}  // namespace idiophone::mesh
