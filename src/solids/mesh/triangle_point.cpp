#include "idiophone/solids/mesh/triangle_point.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace idiophone::mesh {

Vector3 at_weights(const TrianglePoints& corners, const Vector3& weights) {
  return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
}

double longest_edge(const TrianglePoints& corners) {
  const auto& [a, b, c] = corners;
  return std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
}

Vector3 nearest_weights(const TrianglePoints& corners, const Vector3& point) {
  const auto& [a, b, c] = corners;
  const Vector3 normal = (b - a).cross(c - a);
  const double square = normal.squaredNorm();
  if (square > 0.0) {
    const double wb = (point - a).cross(c - a).dot(normal) / square;
    const double wc = (b - a).cross(point - a).dot(normal) / square;
    if (wb >= 0.0 && wc >= 0.0 && wb + wc <= 1.0) {
      return {1.0 - wb - wc, wb, wc};
    }
  }
  Vector3 best = Vector3::UnitX();
  for (std::size_t from = 0; from < 3; ++from) {
    const std::size_t to = (from + 1) % 3;
    const Vector3 edge = corners[to] - corners[from];
    const double length = edge.squaredNorm();
    const double along = length > 0.0 ? std::clamp((point - corners[from]).dot(edge) / length, 0.0, 1.0) : 0.0;
    Vector3 weights = Vector3::Zero();
    weights[static_cast<Index>(from)] = 1.0 - along;
    weights[static_cast<Index>(to)] += along;
    if ((at_weights(corners, weights) - point).norm() < (at_weights(corners, best) - point).norm()) {
      best = weights;
    }
  }
  return best;
}

}  // namespace idiophone::mesh
