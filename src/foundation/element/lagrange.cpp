#include "idiophone/foundation/element/lagrange.hpp"

namespace idiophone::element {

Lagrange lagrange(const Eigen::VectorXd& nodes, double x) {
  const Eigen::Index count = nodes.size();
  Lagrange result{Eigen::VectorXd::Ones(count), Eigen::VectorXd::Zero(count)};
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = 0; b < count; ++b) {
      if (b != a) {  // the product so far times (x - x_b)/(x_a - x_b)
        const double scale = 1 / (nodes[a] - nodes[b]);
        result.slopes[a] = (result.slopes[a] * (x - nodes[b]) + result.values[a]) * scale;
        result.values[a] *= (x - nodes[b]) * scale;
      }
    }
  }
  return result;
}

Eigen::VectorXd evenly_spaced_nodes(int order) {
  return Eigen::VectorXd::LinSpaced(order + 1, -1.0, 1.0);
}

}  // namespace idiophone::element
