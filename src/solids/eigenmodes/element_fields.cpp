#include "element_fields.hpp"

#include <Eigen/LU>

#include "idiophone/foundation/element/lobatto.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/solids/solid/elasticity.hpp"

namespace idiophone::eigenmodes {

ShapesAtPoints::ShapesAtPoints(element::Type type, const std::vector<Vector3>& points) {
  const auto count = static_cast<Eigen::Index>(points.size());
  reference_.values.resize(count, element::node_count(type));
  reference_.slopes.fill(reference_.values);
  for (Eigen::Index q = 0; q < count; ++q) {
    reference_.values.row(q) = element::shape_functions(type, points[q]);
    const Eigen::MatrixX3d gradients = element::shape_gradients(type, points[q]);
    for (int k = 0; k < 3; ++k) {
      reference_.slopes[k].row(q) = gradients.col(k);
    }
  }
}

ElementPoints ShapesAtPoints::points_of(const mesh::Mesh& mesh, Index element, const Eigen::VectorXd& weights) const {
  const auto nodes = mesh.element_nodes(element);
  Eigen::MatrixX3d positions(nodes.size(), 3);
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    positions.row(static_cast<Eigen::Index>(a)) = mesh.nodes[nodes[a]];
  }
  ElementPoints points{.weights = weights, .inverse = {}};
  for (auto& row : points.inverse) {
    row.fill(weights);
  }
  std::array<Eigen::MatrixX3d, 3> jacobian;  // [k] of dX/dxi_k
  for (int k = 0; k < 3; ++k) {
    jacobian[k] = reference_.slopes[k] * positions;
  }
  for (Eigen::Index q = 0; q < weights.size(); ++q) {
    Eigen::Matrix3d at_point;
    for (int k = 0; k < 3; ++k) {
      at_point.col(k) = jacobian[k].row(q);
    }
    const Eigen::Matrix3d inverse = at_point.inverse();
    points.weights[q] *= at_point.determinant();
    for (int k = 0; k < 3; ++k) {
      for (int l = 0; l < 3; ++l) {
        points.inverse[k][l][q] = inverse(k, l);
      }
    }
  }
  return points;
}

ShapeTable ShapesAtPoints::on(const ElementPoints& points) const {
  ShapeTable table{.values = reference_.values, .slopes = {}};
  for (int l = 0; l < 3; ++l) {
    table.slopes[l] = points.inverse[0][l].asDiagonal() * reference_.slopes[0];
    table.slopes[l] += points.inverse[1][l].asDiagonal() * reference_.slopes[1];
    table.slopes[l] += points.inverse[2][l].asDiagonal() * reference_.slopes[2];
  }
  return table;
}

CubeRule::CubeRule(element::Type type) {
  const element::Lobatto& plane = element::lobatto(type.plane + 2);
  const element::Lobatto& thickness = element::lobatto(type.thickness + 2);
  weights.resize(plane.nodes.size() * plane.nodes.size() * thickness.nodes.size());
  for (Eigen::Index k = 0; k < thickness.nodes.size(); ++k) {
    for (Eigen::Index j = 0; j < plane.nodes.size(); ++j) {
      for (Eigen::Index i = 0; i < plane.nodes.size(); ++i) {
        weights[std::ssize(points)] = plane.weights[i] * plane.weights[j] * thickness.weights[k];
        points.emplace_back(plane.nodes[i], plane.nodes[j], thickness.nodes[k]);
      }
    }
  }
}

ModeFields::ModeFields(const ShapeTable& table, std::span<const Index> nodes, const Eigen::MatrixXd& shapes) {
  const auto count = static_cast<Eigen::Index>(nodes.size());
  std::array<std::array<Eigen::MatrixXd, 3>, 3> slope;  // [i][k] of du_i/dX_k
  for (int i = 0; i < 3; ++i) {
    Eigen::MatrixXd values(count, shapes.cols());
    for (Eigen::Index a = 0; a < count; ++a) {
      values.row(a) = shapes.row(3 * nodes[a] + i);
    }
    displacement[i] = table.values * values;
    for (int k = 0; k < 3; ++k) {
      slope[i][k] = table.slopes[k] * values;
    }
  }
  for (int r = 0; r < 6; ++r) {
    const auto [i, k] = solid::direction_pairs[r];
    strain[r] = slope[i][k];
    if (i != k) {
      strain[r] += slope[k][i];
    }
  }
}

std::array<Eigen::MatrixXd, 6> combined(const Eigen::Matrix<double, 6, 6>& matrix,
                                        const std::array<Eigen::MatrixXd, 6>& fields) {
  std::array<Eigen::MatrixXd, 6> result;
  for (int r = 0; r < 6; ++r) {
    result[r] = Eigen::MatrixXd::Zero(fields[0].rows(), fields[0].cols());
    for (int s = 0; s < 6; ++s) {
      if (matrix(r, s) != 0) {
        result[r] += matrix(r, s) * fields[s];
      }
    }
  }
  return result;
}

}  // namespace idiophone::eigenmodes
