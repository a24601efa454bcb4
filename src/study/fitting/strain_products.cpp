#include "strain_products.hpp"

#include <Eigen/LU>
#include <cmath>

#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::fitting {

namespace {

/// Calls f(number, p, q) for each pair p <= q of the six strains.
template <class Function>
void for_each_pair_of_strains(Function f) {
  std::size_t number = 0;
  for (int p = 0; p < 6; ++p) {
    for (int q = p; q < 6; ++q) {
      f(number++, p, q);
    }
  }
}

/// Strains at the quadrature points of an element from the displacements of its nodes, each times the root of the
/// volume of its point. [6 x points, 3 x nodes]: all points of a strain, then the next strain
Eigen::MatrixXd strain_operator(const element::ReferenceElement& element, const Eigen::Matrix3Xd& x) {
  const auto points = static_cast<Eigen::Index>(element.quadrature.size());
  Eigen::MatrixXd strains = Eigen::MatrixXd::Zero(6 * points, 3 * x.cols());
  for (Eigen::Index k = 0; k < points; ++k) {
    const element::QuadraturePoint& point = element.quadrature[k];
    const Eigen::Matrix3d jacobian = x * point.gradient;
    const Eigen::MatrixX3d gradient =
        std::sqrt(point.weight * jacobian.determinant()) * point.gradient * jacobian.inverse();
    for (int p = 0; p < 6; ++p) {
      const auto [i, j] = solid::direction_pairs[p];
      for (Eigen::Index a = 0; a < x.cols(); ++a) {
        strains(p * points + k, 3 * a + i) = gradient(a, j);
        strains(p * points + k, 3 * a + j) = gradient(a, i);
      }
    }
  }
  return strains;
}

}  // namespace

StrainProducts::StrainProducts(const mesh::Part& part, const Eigen::MatrixXd& shapes) {
  const mesh::BodyPart& body = part.bodies.front();
  const element::ReferenceElement& element = element::reference(body.element);
  const auto points = static_cast<Eigen::Index>(element.quadrature.size());
  products_.fill(Eigen::MatrixXd::Zero(shapes.cols(), shapes.cols()));
  Eigen::Matrix3Xd x(3, element::node_count(body.element));
  Eigen::MatrixXd u(3 * x.cols(), shapes.cols());
  for (std::size_t e = 0; e < body.element_ids.size(); ++e) {
    const auto nodes = body.element_nodes(e);
    for (Eigen::Index a = 0; a < x.cols(); ++a) {
      x.col(a) = part.reference[nodes[a]];
      u.middleRows<3>(3 * a) = shapes.middleRows<3>(3 * static_cast<Eigen::Index>(nodes[a]));
    }
    const Eigen::MatrixXd strains = strain_operator(element, x) * u;
    for_each_pair_of_strains([&](std::size_t number, int p, int q) {
      products_[number].noalias() +=
          strains.middleRows(p * points, points).transpose() * strains.middleRows(q * points, points);
    });
  }
  for (Eigen::MatrixXd& product : products_) {
    product += product.transpose().eval();
  }
}

solid::StiffnessMatrix StrainProducts::of(const Eigen::VectorXd& factors) const {
  solid::StiffnessMatrix products;
  for_each_pair_of_strains([&](std::size_t number, int p, int q) {
    products(p, q) = products(q, p) = factors.dot(products_[number] * factors) / 2;
  });
  return products;
}

Eigen::MatrixXd StrainProducts::energies(const solid::StiffnessMatrix& stiffness) const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(products_[0].rows(), products_[0].cols());
  for_each_pair_of_strains(
      [&](std::size_t number, int p, int q) { sum += (p == q ? 0.5 : 1.0) * stiffness(p, q) * products_[number]; });
  return sum;
}

}  // namespace idiophone::fitting
