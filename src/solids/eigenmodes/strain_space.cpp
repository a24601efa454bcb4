#include "strain_space.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::eigenmodes {

using solid::direction_pairs;

namespace {

Eigen::Index points_of(const mesh::BodyPart& body) {
  return std::ssize(body.element_ids) * std::ssize(element::reference(body.element).quadrature);
}

/// The values of fields at an element's nodes. [3 x fields, nodes]: three rows for a field
Eigen::MatrixXd at_nodes(const Eigen::Ref<const Eigen::MatrixXd>& fields, std::span<const Index> nodes) {
  Eigen::MatrixXd values(3 * fields.cols(), std::ssize(nodes));
  for (Eigen::Index a = 0; a < values.cols(); ++a) {
    const Eigen::Index first = Eigen::Index{3} * nodes[static_cast<std::size_t>(a)];
    values.col(a) = fields.middleRows<3>(first).reshaped();
  }
  return values;
}

/// [k][j] [modes x points] du_k/dX_j of modes.
/// @param gradients  [3 x modes, 3 x points]
std::array<std::array<Eigen::MatrixXd, 3>, 3> components(const Eigen::MatrixXd& gradients) {
  std::array<std::array<Eigen::MatrixXd, 3>, 3> parts;
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 3; ++j) {
      parts[k][j] = gradients(Eigen::seqN(k, gradients.rows() / 3, 3), Eigen::seqN(j, gradients.cols() / 3, 3));
    }
  }
  return parts;
}

/// What a mode and each mode up to it add to 1/2 (grad u)^T grad u together, half for each order of the two; shears
/// count twice. [mode + 1, 6 x points]
/// @param gradients  as of components()
void find_pairs(const std::array<std::array<Eigen::MatrixXd, 3>, 3>& gradients, Eigen::Index mode,
                Eigen::Ref<Eigen::MatrixXd> pairs) {
  for (Eigen::Index p = 0; p < gradients[0][0].cols(); ++p) {
    const auto product = [&](int i, int j) {
      const auto term = [&](int k) { return gradients[k][i](mode, p) / 2 * gradients[k][j].col(p).head(mode + 1); };
      return term(0) + term(1) + term(2);
    };
    for (int c = 0; c < 6; ++c) {
      const auto [i, j] = direction_pairs[c];
      pairs.col(6 * p + c) = product(i, j);
      if (i != j) {
        pairs.col(6 * p + c) += product(j, i);
      }
    }
  }
}

}  // namespace

StrainSpace::StrainSpace(const mesh::Part& part, std::span<const std::vector<solid::StiffnessMatrix>> stiffness,
                         std::vector<NodeSpring> springs)
    : part_(part), springs_(std::move(springs)) {
  for (const std::vector<solid::StiffnessMatrix>& of_body : stiffness) {
    std::vector<Matrix6>& roots = roots_.emplace_back();
    for (const solid::StiffnessMatrix& of_region : of_body) {
      roots.emplace_back(of_region.llt().matrixL());
    }
  }
  for (const mesh::BodyPart& body : part.bodies) {
    points_ += points_of(body);
  }
  size_ = 6 * points_;
  for (const NodeSpring& spring : springs_) {
    size_ += spring.root.rows();
  }
}

void StrainSpace::for_each_element(const std::function<void(const Element& element)>& visit) const {
  Eigen::Index first = 0;
  for (std::size_t body = 0; body < part_.bodies.size(); ++body) {
    for_each_element(body, first, visit);
    first += points_of(part_.bodies[body]);
  }
}

void StrainSpace::for_each_element(std::size_t number, Eigen::Index first,
                                   const std::function<void(const Element& element)>& visit) const {
  const mesh::BodyPart& body = part_.bodies[number];
  const auto& quadrature = element::reference(body.element).quadrature;
  Element element;
  element.first = first;
  element.slopes.resize(quadrature.front().gradient.rows(), 3 * std::ssize(quadrature));
  element.volumes.resize(std::ssize(quadrature));
  for (std::size_t e = 0; e < body.element_ids.size(); ++e, element.first += element.points()) {
    element.nodes = body.element_nodes(e);
    element.root = &roots_[number][static_cast<std::size_t>(body.region(e))];
    Eigen::Matrix3Xd places(3, std::ssize(element.nodes));
    for (Eigen::Index a = 0; a < places.cols(); ++a) {
      places.col(a) = part_.reference[element.nodes[static_cast<std::size_t>(a)]];
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

template <class StrainOf>
Eigen::MatrixXd StrainSpace::strains(const Eigen::Ref<const Eigen::MatrixXd>& fields, const StrainOf& strain_of) const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size(), fields.cols());
  for_each_element([&](const Element& element) {
    const Eigen::MatrixXd gradients = at_nodes(fields, element.nodes) * element.slopes;
    for (Eigen::Index p = 0; p < element.points(); ++p) {
      const Matrix6 root = std::sqrt(element.volumes[p]) * element.root->transpose();
      for (Eigen::Index field = 0; field < fields.cols(); ++field) {
        const Eigen::Matrix3d full = strain_of(gradients.block<3, 3>(3 * field, 3 * p));
        Eigen::Vector<double, 6> strain;
        for (int c = 0; c < 6; ++c) {
          strain[c] = (c < 3 ? 1 : 2) * full(direction_pairs[c][0], direction_pairs[c][1]);
        }
        result.col(field).segment<6>(6 * (element.first + p)) = root * strain;
      }
    }
  });
  return result;
}

Eigen::MatrixXd StrainSpace::linear(const Eigen::Ref<const Eigen::MatrixXd>& fields) const {
  Eigen::MatrixXd result = strains(
      fields, [](const Eigen::Matrix3d& gradient) -> Eigen::Matrix3d { return (gradient + gradient.transpose()) / 2; });
  Eigen::Index first = 6 * points_;
  for (const NodeSpring& spring : springs_) {
    auto stretches = result.middleRows(first, spring.root.rows());
    for (std::size_t a = 0; a < spring.nodes.size(); ++a) {
      stretches += spring.root.middleCols<3>(3 * static_cast<Eigen::Index>(a)) *
                   fields.middleRows<3>(3 * Eigen::Index{spring.nodes[a]});
    }
    first += spring.root.rows();
  }
  return result;
}

Eigen::MatrixXd StrainSpace::quadratic(const Eigen::Ref<const Eigen::MatrixXd>& fields) const {
  return strains(
      fields, [](const Eigen::Matrix3d& gradient) -> Eigen::Matrix3d { return gradient.transpose() * gradient / 2; });
}

Eigen::MatrixXd StrainSpace::stresses_of(const Eigen::Ref<const Eigen::MatrixXd>& strains, const Element& element) {
  Eigen::MatrixXd stresses(6 * element.points(), strains.cols());
  for (Eigen::Index p = 0; p < element.points(); ++p) {
    stresses.middleRows<6>(6 * p) =
        std::sqrt(element.volumes[p]) * *element.root * strains.middleRows<6>(6 * (element.first + p));
  }
  return stresses;
}

Eigen::MatrixXd StrainSpace::forces(const Eigen::Ref<const Eigen::MatrixXd>& strains) const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3 * std::ssize(part_.reference), strains.cols());
  for_each_element([&](const Element& element) {
    const Eigen::MatrixXd listed = stresses_of(strains, element);
    Eigen::MatrixXd stresses(3 * strains.cols(), 3 * element.points());
    for (Eigen::Index n = 0; n < strains.cols(); ++n) {
      for (Eigen::Index p = 0; p < element.points(); ++p) {
        for (int c = 0; c < 6; ++c) {
          const auto [i, j] = direction_pairs[c];
          stresses(3 * n + i, 3 * p + j) = stresses(3 * n + j, 3 * p + i) = listed(6 * p + c, n);
        }
      }
    }
    const Eigen::MatrixXd nodal = stresses * element.slopes.transpose();
    for (Eigen::Index a = 0; a < nodal.cols(); ++a) {
      result.middleRows<3>(Eigen::Index{3} * element.nodes[static_cast<std::size_t>(a)]).reshaped() += nodal.col(a);
    }
  });
  Eigen::Index first = 6 * points_;
  for (const NodeSpring& spring : springs_) {
    for (std::size_t a = 0; a < spring.nodes.size(); ++a) {
      result.middleRows<3>(3 * Eigen::Index{spring.nodes[a]}) +=
          spring.root.middleCols<3>(3 * static_cast<Eigen::Index>(a)).transpose() *
          strains.middleRows(first, spring.root.rows());
    }
    first += spring.root.rows();
  }
  return result;
}

std::vector<Eigen::MatrixXd> StrainSpace::products(const Eigen::MatrixXd& strains,
                                                   const Eigen::MatrixXd& shapes) const {
  constexpr Eigen::Index at_once = 8;  // modes whose pairs are multiplied together
  const Eigen::Index modes = shapes.cols();
  const auto pairs_before = [](Eigen::Index mode) { return mode * (mode + 1) / 2; };
  Eigen::MatrixXd of_pairs = Eigen::MatrixXd::Zero(pairs_before(modes), strains.cols());
  for_each_element([&](const Element& element) {
    const auto gradients = components(at_nodes(shapes, element.nodes) * element.slopes);
    const Eigen::MatrixXd stresses = stresses_of(strains, element);
    for (Eigen::Index begin = 0; begin < modes; begin += at_once) {
      const Eigen::Index end = std::min(begin + at_once, modes);
      const Eigen::Index first = pairs_before(begin), count = pairs_before(end) - first;
      Eigen::MatrixXd pairs(count, stresses.rows());
      for (Eigen::Index mode = begin; mode < end; ++mode) {
        find_pairs(gradients, mode, pairs.middleRows(pairs_before(mode) - first, mode + 1));
      }
      of_pairs.middleRows(first, count).noalias() += pairs * stresses;
    }
  });
  std::vector<Eigen::MatrixXd> result(static_cast<std::size_t>(strains.cols()), Eigen::MatrixXd(modes, modes));
  for (Eigen::Index n = 0; n < strains.cols(); ++n) {
    for (Eigen::Index mode = 0; mode < modes; ++mode) {
      const auto row = of_pairs.col(n).segment(pairs_before(mode), mode + 1);
      result[static_cast<std::size_t>(n)].row(mode).head(mode + 1) = row.transpose();
      result[static_cast<std::size_t>(n)].col(mode).head(mode + 1) = row;
    }
  }
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
