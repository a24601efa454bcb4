#include "element_shape.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::mesh {

namespace {

/// det(dX/dxi), X = sum_a N_a X_a.
/// @param gradient  [nodes x 3] dN_a/dxi_k
double jacobian(const ElementShape& shape, const Eigen::MatrixX3d& gradient) {
  Eigen::Matrix3d tangents = Eigen::Matrix3d::Zero();
  for (Eigen::Index a = 0; a < gradient.rows(); ++a) {
    tangents += shape.nodes[a] * gradient.row(a);
  }
  return tangents.determinant();
}

double smallest_jacobian(const ElementShape& shape) {
  const element::ReferenceElement& reference = element::reference(shape.type);
  double smallest = std::numeric_limits<double>::infinity();
  for (const Eigen::MatrixX3d& gradient : reference.corner_gradients) {
    smallest = std::min(smallest, jacobian(shape, gradient));
  }
  for (const element::QuadraturePoint& point : reference.quadrature) {
    smallest = std::min(smallest, jacobian(shape, point.gradient));
  }
  return smallest;
}

}  // namespace

ElementShape shape_of(const Mesh& mesh, Index number) {
  ElementShape shape{.type = mesh.element, .nodes = {}};
  std::ranges::transform(mesh.element_nodes(number), std::back_inserter(shape.nodes),
                         [&](Index node) { return mesh.nodes[node]; });
  return shape;
}

Vector3 centre_of(const ElementShape& shape) {
  const std::vector<int>& corners = element::reference(shape.type).corners;
  Vector3 sum = Vector3::Zero();
  for (const int corner : corners) {
    sum += shape.nodes[corner];
  }
  return sum / static_cast<double>(corners.size());
}

std::vector<double> edge_lengths(const ElementShape& shape) {
  std::vector<double> lengths;
  for (const auto& [i, j] : element::reference(shape.type).edges) {
    lengths.push_back((shape.nodes[j] - shape.nodes[i]).norm());
  }
  return lengths;
}

double volume_of(const ElementShape& shape) {
  double sum = 0.0;
  for (const element::QuadraturePoint& point : element::reference(shape.type).quadrature) {
    sum += point.weight * jacobian(shape, point.gradient);
  }
  return sum;
}

double quality_of(const ElementShape& shape) {
  const auto lengths = edge_lengths(shape);
  const double mean_square =
      std::inner_product(lengths.begin(), lengths.end(), lengths.begin(), 0.0) / static_cast<double>(lengths.size());
  if (mean_square == 0.0) {
    return 0.0;  // all corners in one place
  }
  const double regular = element::reference(shape.type).regular_jacobian * mean_square * std::sqrt(mean_square);
  return smallest_jacobian(shape) / regular;
}

}  // namespace idiophone::mesh
