#include "strain_products.hpp"

#include <Eigen/LU>

#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::fitting {

solid::StiffnessMatrix strain_products(const mesh::Part& part, std::span<const double> shape) {
  const mesh::BodyPart& body = part.bodies.front();
  const element::ReferenceElement& element = element::reference(body.element);
  const Eigen::Map<const Eigen::Matrix3Xd> displacement(shape.data(), 3, static_cast<Eigen::Index>(shape.size() / 3));
  Eigen::Matrix3Xd x(3, element::node_count(body.element));
  Eigen::Matrix3Xd u(3, x.cols());
  solid::StiffnessMatrix products = solid::StiffnessMatrix::Zero();
  for (std::size_t e = 0; e < body.element_ids.size(); ++e) {
    const auto nodes = body.element_nodes(e);
    for (Eigen::Index a = 0; a < x.cols(); ++a) {
      x.col(a) = part.reference[nodes[a]];
      u.col(a) = displacement.col(nodes[a]);
    }
    for (const element::QuadraturePoint& point : element.quadrature) {
      const Eigen::Matrix3d jacobian = x * point.gradient;
      const Eigen::Matrix3d gradient = u * point.gradient * jacobian.inverse();
      Eigen::Vector<double, 6> strain;
      for (int p = 0; p < 6; ++p) {
        const auto [i, j] = solid::direction_pairs[p];
        strain[p] = p < 3 ? gradient(i, i) : gradient(i, j) + gradient(j, i);
      }
      products += point.weight * jacobian.determinant() * strain * strain.transpose();
    }
  }
  return products;
}

}  // namespace idiophone::fitting
