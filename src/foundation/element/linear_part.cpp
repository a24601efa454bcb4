#include "idiophone/foundation/element/linear_part.hpp"

#include <algorithm>

#include "idiophone/foundation/element/gauss.hpp"

namespace idiophone::element {

namespace {

/// Calls visit(weights of the corners at a point, weight of the point). The latter add up to 1. Exact for polynomials
/// of degree 2 points - 2.
template <class Visit>
void for_each_point_of_triangle(int points, const Visit& visit) {
  const Gauss rule = gauss(points);
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < points; ++j) {
      const double rest = 1.0 - rule.places[j];  // the square's edge at 1 becomes the third corner
      visit(Vector3((1.0 - rule.places[i]) * rest, rule.places[i] * rest, rule.places[j]),
            2.0 * rule.weights[i] * rule.weights[j] * rest);
    }
  }
}

}  // namespace

Eigen::Matrix3Xd linear_part(const ReferenceElement& reference, const Face& face, const std::array<int, 3>& corners) {
  const auto [plane, thickness] = orders(reference.type);
  Eigen::Matrix3Xd moments = Eigen::Matrix3Xd::Zero(3, std::ssize(face.nodes));  // of shape functions times weights
  for_each_point_of_triangle(std::max(plane, thickness) + 2, [&](const Vector3& at, double weight) {
    Vector3 xi = Vector3::Zero();
    for (int k = 0; k < 3; ++k) {
      xi += at[k] * reference.nodes[corners.at(k)];
    }
    const Eigen::VectorXd shapes = shape_functions(reference.type, xi);
    moments += weight * at * shapes(face.nodes).transpose();
  });
  // The integrals of products of the weights are 1/6 and 1/12; this is the inverse of their matrix.
  const Eigen::Matrix3d inverse = 12.0 * Eigen::Matrix3d::Identity() - Eigen::Matrix3d::Constant(3.0);
  return inverse * moments;
}

}  // namespace idiophone::element
