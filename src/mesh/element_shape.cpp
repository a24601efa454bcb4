#include "element_shape.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace idiophone::mesh {

namespace {

using Barycentric = std::array<double, 4>;

/// Corners of the edges whose middles are a tet10's nodes 4 to 9.
constexpr std::array<std::array<std::size_t, 2>, 6> edges = {{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};

constexpr std::array<Barycentric, 4> corner_points = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

/// The four-point rule of degree 2, weights 1/4: a = (5 + 3 sqrt(5))/20 at one corner, b = (5 - sqrt(5))/20 at the
/// rest.
constexpr double a = 0.58541019662496845446;
constexpr double b = 0.13819660112501051518;
constexpr std::array<Barycentric, 4> quadrature_points = {{{a, b, b, b}, {b, a, b, b}, {b, b, a, b}, {b, b, b, a}}};

/// det(dX/dxi) with the position as a function of the barycentric coordinates L_i,
/// X = sum_i L_i (2 L_i - 1) X_i + sum_(edges ij) 4 L_i L_j X_ij (tet4: X = sum_i L_i X_i), and xi_k = L_k, k = 1,
/// 2, 3.
double jacobian(const ElementShape& shape, const Barycentric& at) {
  const bool quadratic = shape.type == ElementType::tet10;
  std::array<Vector3, 4> tangents;
  for (std::size_t corner = 0; corner < 4; ++corner) {
    tangents[corner] = (quadratic ? 4.0 * at[corner] - 1.0 : 1.0) * shape.nodes[corner];
  }
  if (quadratic) {
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
      const auto [i, j] = edges[edge];
      tangents[i] += 4.0 * at[j] * shape.nodes[4 + edge];
      tangents[j] += 4.0 * at[i] * shape.nodes[4 + edge];
    }
  }
  return (tangents[1] - tangents[0]).cross(tangents[2] - tangents[0]).dot(tangents[3] - tangents[0]);
}

double smallest_jacobian(const ElementShape& shape) {
  double smallest = jacobian(shape, corner_points[0]);
  if (shape.type == ElementType::tet10) {
    for (std::size_t point = 0; point < 4; ++point) {
      smallest = std::min({smallest, jacobian(shape, corner_points[point]), jacobian(shape, quadrature_points[point])});
    }
  }
  return smallest;
}

}  // namespace

ElementShape shape_of(const Mesh& mesh, Index number) {
  ElementShape shape{.type = mesh.element, .nodes = {}};
  std::ranges::transform(mesh.element_nodes(number), shape.nodes.begin(),
                         [&](Index node) { return mesh.nodes[static_cast<std::size_t>(node)]; });
  return shape;
}

Vector3 centre_of(const ElementShape& shape) {
  return 0.25 * (shape.nodes[0] + shape.nodes[1] + shape.nodes[2] + shape.nodes[3]);
}

std::array<double, 6> edge_lengths(const ElementShape& shape) {
  std::array<double, 6> lengths{};
  std::ranges::transform(edges, lengths.begin(),
                         [&](const auto& edge) { return (shape.nodes[edge[1]] - shape.nodes[edge[0]]).norm(); });
  return lengths;
}

double volume_of(const ElementShape& shape) {
  if (shape.type == ElementType::tet4) {
    return jacobian(shape, corner_points[0]) / 6.0;
  }
  double sum = 0.0;
  for (const auto& point : quadrature_points) {
    sum += jacobian(shape, point);
  }
  return sum / 24.0;
}

double quality_of(const ElementShape& shape) {
  const auto lengths = edge_lengths(shape);
  const double mean_square = std::inner_product(lengths.begin(), lengths.end(), lengths.begin(), 0.0) / 6.0;
  if (mean_square == 0.0) {
    return 0.0;  // all corners in one place
  }
  return std::numbers::sqrt2 * smallest_jacobian(shape) / (mean_square * std::sqrt(mean_square));
}

}  // namespace idiophone::mesh
