#include "twist_error.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "idiophone/foundation/element/lobatto.hpp"

namespace idiophone::accuracy {

namespace {

constexpr double cubic_profile = 1.0918;  // Saint-Venant's 0.6302 t of a wide section over 2 t/sqrt(12)
constexpr int most_cells = 24;            // across: edges further apart do not influence each other

/// The largest value of 4 d^2 (e(end) - e(start)) - integral of d^2 e'^2 + e^2, m3, over functions e that are
/// polynomials of an order in each cell: what the edges take from the torsional stiffness of a section of unit
/// thickness.
/// @param width  of a cell, m
/// @param decay  d, m
double edge_share(int cells, double width, int order, double decay) {
  const element::Lobatto& rule = element::lobatto(order);
  const Eigen::Index size = cells * order + 1;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  const Eigen::MatrixXd stiffness =
      rule.derivative.transpose() * rule.weights.asDiagonal() * rule.derivative * (2 / width);
  for (Eigen::Index start = 0; start + 1 < size; start += order) {
    matrix.block(start, start, order + 1, order + 1) += decay * decay * stiffness;
    matrix.diagonal().segment(start, order + 1) += width / 2 * rule.weights;
  }
  Eigen::VectorXd edges = Eigen::VectorXd::Zero(size);
  edges[0] = -2 * decay * decay;
  edges[size - 1] = 2 * decay * decay;
  return edges.dot(matrix.ldlt().solve(edges));
}

/// How a kind of cells errs where a body twists.
struct Twist {
  double skew;     ///< plates also twist at an angle to the cells, measured
  double lumping;  ///< what the lumped mass adds to the rotary inertia, measured at most: docs/use/mesh_guide.md
};

Twist twist_of(element::Type type) {
  switch (type.kind) {
    case element::Kind::tet4:
    case element::Kind::tet10:
      return {.skew = 1.0, .lumping = 0.5};
    case element::Kind::hex:
      return {.skew = 1.5, .lumping = 0.0};
  }
  element::unknown_kind();
}

}  // namespace

double twist_error(const Cells& cells, const Extents& body) {
  const double width = body.sides[1];
  const double thickness = body.thickness;
  const double decay = thickness / std::sqrt(12.0);
  const auto [skew, lumping] = twist_of(cells.type);
  const auto [plane, through] = element::orders(cells.type);
  const bool cubic = through * std::round(thickness / cells.layer) >= 3;
  const int across = std::max(1, static_cast<int>(std::min(1e6, std::round(width / cells.across))));
  const double even = 4 * decay * decay * width;
  const double exact = cubic_profile * 8 * std::pow(decay, 3) * std::tanh(width / (2 * decay));
  const double found =
      (cubic ? cubic_profile : 1.0) * edge_share(std::min(across, most_cells), width / across, plane, decay);
  const double edges = skew * 600 * std::log2((even - found) / (even - exact));
  const double excess =
      lumping * (cells.across * cells.across + cells.layer * cells.layer) / (width * width + thickness * thickness);
  return std::max(std::abs(edges), 600 * std::log2(1 + excess));
}

}  // namespace idiophone::accuracy
