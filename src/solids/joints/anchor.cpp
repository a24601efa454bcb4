#include "anchor.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "idiophone/foundation/element/reference.hpp"
#include "surface_face.hpp"

namespace idiophone::joints {

Anchor::Anchor(const mesh::Mesh& mesh, const HeldPart& held, Index first_node) : nodes_(held.nodes(mesh)) {
  add_faces(mesh, held.faces);
  add_elements(mesh, held.elements);
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    centre_ += parts_[n] * mesh.nodes[nodes_[n]];
  }
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Vector3& arm = arms_.emplace_back(mesh.nodes[nodes_[n]] - centre_);
    gram += parts_[n] * arm * arm.transpose();
    radius_ = std::max(radius_, arm.norm());
    nodes_[n] += first_node;
  }
  inverse_gram_ = gram.inverse();
}

std::size_t Anchor::place_of(Index node) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(nodes_, node) - nodes_.begin());
}

void Anchor::add_faces(const mesh::Mesh& mesh, const std::vector<mesh::ElementFace>& faces) {
  shares_.resize(nodes_.size());
  for (const mesh::ElementFace& of_element : faces) {
    const SurfaceFace face(mesh, of_element, 0);
    for (const auto& [place, weight] : face.quadrature(face.order() + 1)) {
      const SurfaceFace::Spot spot = face.at(place);
      const double area = weight * spot.normal().norm();
      for (std::size_t n = 0; n < face.nodes().size(); ++n) {
        shares_[place_of(face.nodes()[n])] += area * spot.values[static_cast<Eigen::Index>(n)];
      }
      middle_ += area * spot.position;
      normal_ += weight * spot.normal();
    }
  }
  const double area = std::accumulate(shares_.begin(), shares_.end(), 0.0);
  std::ranges::for_each(shares_, [&](double& share) { share /= area; });
  middle_ /= area;
  normal_ /= area;
}

void Anchor::add_elements(const mesh::Mesh& mesh, const std::vector<Index>& elements) {
  parts_.resize(nodes_.size());
  double volume = 0.0;
  for (const element::QuadraturePoint& point : element::reference(mesh.element).quadrature) {
    const Eigen::VectorXd values = element::shape_functions(mesh.element, point.place);
    for (const Index element : elements) {
      const auto nodes = mesh.element_nodes(element);
      Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        jacobian += mesh.nodes[nodes[n]] * point.gradient.row(static_cast<Eigen::Index>(n));
      }
      const double here = point.weight * jacobian.determinant();
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        parts_[place_of(nodes[n])] +=
            here * values[static_cast<Eigen::Index>(n)] * values[static_cast<Eigen::Index>(n)];
      }
      volume += here;
    }
  }
  const double sum = std::accumulate(parts_.begin(), parts_.end(), 0.0);
  std::ranges::for_each(parts_, [&](double& part) { part /= sum; });
  width_ = std::cbrt(volume);
}

std::vector<double> Anchor::weights_at(const Vector3& point) const {
  std::vector<double> weights = slopes_along(point - centre_);
  std::ranges::transform(weights, parts_, weights.begin(), std::plus<>());
  return weights;
}

std::vector<double> Anchor::slopes_along(const Vector3& direction) const {
  const Vector3 gradient = inverse_gram_ * direction;
  std::vector<double> slopes(nodes_.size());
  std::ranges::transform(arms_, parts_, slopes.begin(),
                         [&](const Vector3& arm, double part) { return part * arm.dot(gradient); });
  return slopes;
}

}  // namespace idiophone::joints
