#include "strain_space.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::eigenmodes {

using solid::direction_pairs;

namespace {

/// The values of fields at an element's nodes. [3 x fields, nodes]: three rows for a field
Eigen::MatrixXd at_nodes(const Eigen::Ref<const Eigen::MatrixXd>& fields, std::span<const Index> nodes) {
  Eigen::MatrixXd values(3 * fields.cols(), std::ssize(nodes));
  for (Eigen::Index a = 0; a < values.cols(); ++a) {
    const Eigen::Index first = 3 * nodes[static_cast<std::size_t>(a)];
    values.col(a) = fields.middleRows<3>(first).reshaped();
  }
  return values;
}

}  // namespace

StrainSpace::StrainSpace(const mesh::BodyPart& body, std::span<const Vector3> reference,
                         std::span<const solid::StiffnessMatrix> stiffness)
    : body_(body),
      reference_(reference),
      points_(std::ssize(body.element_ids) * std::ssize(element::reference(body.element).quadrature)) {
  for (const solid::StiffnessMatrix& of_region : stiffness) {
    roots_.emplace_back(of_region.llt().matrixL());
  }
}

void StrainSpace::for_each_element(const std::function<void(const Element& element)>& visit) const {
  const auto& quadrature = element::reference(body_.element).quadrature;
  Element element;
  element.slopes.resize(quadrature.front().gradient.rows(), 3 * std::ssize(quadrature));
  element.volumes.resize(std::ssize(quadrature));
  for (std::size_t e = 0; e < body_.element_ids.size(); ++e, element.first += element.points()) {
    element.nodes = body_.element_nodes(e);
    element.region = static_cast<std::size_t>(body_.region(e));
    Eigen::Matrix3Xd places(3, std::ssize(element.nodes));
    for (Eigen::Index a = 0; a < places.cols(); ++a) {
      places.col(a) = reference_[element.nodes[static_cast<std::size_t>(a)]];
    }
    for (Eigen::Index p = 0; p < element.points(); ++p) {
      const element::QuadraturePoint& point = quadrature[static_cast<std::size_t>(p)];
      const Eigen::Matrix3d jacobian = places * point.gradient;
      element.slopes.middleCols<3>(3 * p) = point.gradient * jacobian.inverse();
      element.volumes[p] = point.weight * jacobian.determinant();
    }
    visit(element);
  }
}

Eigen::VectorXd StrainSpace::strain(
    const Eigen::VectorXd& field,
    const std::function<Eigen::Matrix3d(const Eigen::Matrix3d& gradient)>& strain_of) const {
  Eigen::VectorXd result(size());
  for_each_element([&](const Element& element) {
    const Eigen::MatrixXd gradients = at_nodes(field, element.nodes) * element.slopes;
    for (Eigen::Index p = 0; p < element.points(); ++p) {
      const Eigen::Matrix3d full = strain_of(gradients.middleCols<3>(3 * p));
      Eigen::Vector<double, 6> strain;
      for (int c = 0; c < 6; ++c) {
        strain[c] = (c < 3 ? 1 : 2) * full(direction_pairs[c][0], direction_pairs[c][1]);
      }
      result.segment<6>(6 * (element.first + p)) =
          std::sqrt(element.volumes[p]) * roots_[element.region].transpose() * strain;
    }
  });
  return result;
}

Eigen::VectorXd StrainSpace::linear(const Eigen::VectorXd& field) const {
  return strain(
      field, [](const Eigen::Matrix3d& gradient) -> Eigen::Matrix3d { return (gradient + gradient.transpose()) / 2; });
}

Eigen::VectorXd StrainSpace::quadratic(const Eigen::VectorXd& field) const {
  return strain(field,
                [](const Eigen::Matrix3d& gradient) -> Eigen::Matrix3d { return gradient.transpose() * gradient / 2; });
}

Eigen::Matrix3d StrainSpace::stress(const Eigen::Ref<const Eigen::VectorXd>& strain, const Element& element,
                                    Eigen::Index point) const {
  const Eigen::Vector<double, 6> s =
      std::sqrt(element.volumes[point]) * roots_[element.region] * strain.segment<6>(6 * (element.first + point));
  Eigen::Matrix3d full;
  for (int c = 0; c < 6; ++c) {
    const auto [i, j] = direction_pairs[c];
    full(i, j) = full(j, i) = s[c];
  }
  return full;
}

Eigen::VectorXd StrainSpace::forces(const Eigen::VectorXd& strain) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(3 * std::ssize(reference_));
  for_each_element([&](const Element& element) {
    Eigen::Matrix3Xd stresses(3, 3 * element.points());
    for (Eigen::Index p = 0; p < element.points(); ++p) {
      stresses.middleCols<3>(3 * p) = stress(strain, element, p);
    }
    const Eigen::Matrix3Xd nodal = stresses * element.slopes.transpose();
    for (Eigen::Index a = 0; a < nodal.cols(); ++a) {
      result.segment<3>(3 * element.nodes[static_cast<std::size_t>(a)]) += nodal.col(a);
    }
  });
  return result;
}

std::vector<Eigen::MatrixXd> StrainSpace::products(const Eigen::MatrixXd& strains,
                                                   const Eigen::MatrixXd& shapes) const {
  const Eigen::Index modes = shapes.cols();
  std::vector<Eigen::MatrixXd> result(static_cast<std::size_t>(strains.cols()), Eigen::MatrixXd::Zero(modes, modes));
  for_each_element([&](const Element& element) {
    const Eigen::MatrixXd gradients = at_nodes(shapes, element.nodes) * element.slopes;
    // [modes, 9 x points], a row of grad u after another, so that one product adds up all rows and points.
    const auto rows = gradients.reshaped(3, modes * 3 * element.points());
    Eigen::MatrixXd all(modes, 9 * element.points());
    Eigen::MatrixXd stressed(modes, all.cols());
    for (Eigen::Index row = 0; row < 3; ++row) {
      all.middleCols(row * 3 * element.points(), 3 * element.points()) =
          rows.row(row).reshaped(modes, 3 * element.points());
    }
    for (Eigen::Index n = 0; n < strains.cols(); ++n) {
      for (Eigen::Index p = 0; p < element.points(); ++p) {
        const Eigen::Matrix3d s = stress(strains.col(n), element, p);
        for (Eigen::Index row = 0; row < 3; ++row) {
          const Eigen::Index column = 3 * (row * element.points() + p);
          stressed.middleCols<3>(column) = all.middleCols<3>(column) * (s / 2);
        }
      }
      result[static_cast<std::size_t>(n)].noalias() += all * stressed.transpose();
    }
  });
  return result;
}

Eigen::MatrixXd StrainSpace::rotations(const Eigen::MatrixXd& shapes) const {
  const Eigen::Index modes = shapes.cols();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(modes, modes);
  double volume = 0.0;
  for_each_element([&](const Element& element) {
    const Eigen::MatrixXd gradients = at_nodes(shapes, element.nodes) * element.slopes;
    Eigen::Matrix3Xd curls(3, modes);
    for (Eigen::Index p = 0; p < element.points(); ++p) {
      for (Eigen::Index mode = 0; mode < modes; ++mode) {
        const auto g = gradients.block<3, 3>(3 * mode, 3 * p);
        curls.col(mode) << g(2, 1) - g(1, 2), g(0, 2) - g(2, 0), g(1, 0) - g(0, 1);
      }
      result.noalias() += element.volumes[p] / 4 * curls.transpose() * curls;
    }
    volume += element.volumes.sum();
  });
  return result / volume;
}

}  // namespace idiophone::eigenmodes
