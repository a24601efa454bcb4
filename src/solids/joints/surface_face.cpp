#include "surface_face.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "idiophone/foundation/element/gauss.hpp"

namespace idiophone::joints {

namespace {

/// Of the reference element, at a place of its face.
Vector3 reference_place(const element::ReferenceElement& element, const element::Face& face, const FacePlace& place) {
  const Vector3& origin = element.nodes[face.corners.front()];
  return origin + place[0] * (element.nodes[face.corners[1]] - origin) +
         place[1] * (element.nodes[face.corners.back()] - origin);
}

}  // namespace

SurfaceFace::SurfaceFace(const mesh::Mesh& mesh, const mesh::ElementFace& face, Index first_node)
    : type_(mesh.element), face_(element::reference(mesh.element).faces[face.side]) {
  const auto nodes = mesh.element_nodes(face.element);
  for (const int place : face_.nodes) {
    nodes_.push_back(first_node + nodes[place]);
    positions_.push_back(mesh.nodes[nodes[place]]);
    centre_ += positions_.back() / static_cast<double>(face_.nodes.size());
  }
  for (const Vector3& position : positions_) {
    radius_ = std::max(radius_, (position - centre_).norm());
  }
  for (const auto& [a, b, c] : face_.triangles) {
    const Vector3& corner = mesh.nodes[nodes[a]];
    area_ += (mesh.nodes[nodes[b]] - corner).cross(mesh.nodes[nodes[c]] - corner).norm() / 2;
  }
}

Vector3 SurfaceFace::Spot::normal() const {
  return tangents.col(0).cross(tangents.col(1));
}

int SurfaceFace::order() const {
  const element::Orders orders = element::orders(type_);
  return std::max(orders.plane, orders.thickness);
}

SurfaceFace::Spot SurfaceFace::at(const FacePlace& place) const {
  const element::ReferenceElement& element = element::reference(type_);
  const Vector3 xi = reference_place(element, face_, place);
  const Eigen::VectorXd values = element::shape_functions(type_, xi);
  const Eigen::MatrixX3d gradients = element::shape_gradients(type_, xi);
  Eigen::Matrix<double, 3, 2> along;  // d xi/ds, d xi/dt
  along << reference_place(element, face_, {1, 0}) - reference_place(element, face_, {0, 0}),
      reference_place(element, face_, {0, 1}) - reference_place(element, face_, {0, 0});
  const auto count = static_cast<Eigen::Index>(nodes_.size());
  Spot spot{Eigen::VectorXd(count), Eigen::MatrixX2d(count, 2), Vector3::Zero(), Eigen::Matrix<double, 3, 2>::Zero()};
  for (Eigen::Index n = 0; n < count; ++n) {
    spot.values[n] = values[face_.nodes[n]];
    spot.slopes.row(n) = gradients.row(face_.nodes[n]) * along;
    spot.position += spot.values[n] * positions_[n];
    spot.tangents += positions_[n] * spot.slopes.row(n);
  }
  return spot;
}

/// A triangle is a square one of whose sides has collapsed (Stroud's conical product).
std::vector<SurfaceFace::Point> SurfaceFace::quadrature(int points) const {
  const element::Gauss rule = element::gauss(points);
  std::vector<Point> all;
  for (int i = 0; i < points; ++i) {
    const double width = is_triangle() ? 1 - rule.places[i] : 1.0;
    for (int j = 0; j < points; ++j) {
      all.push_back({{rule.places[i], rule.places[j] * width}, rule.weights[i] * rule.weights[j] * width});
    }
  }
  return all;
}

bool SurfaceFace::contains(const FacePlace& place) const {
  constexpr double margin = 1e-6;
  const double most = is_triangle() ? 1 - place.sum() : 1 - place.maxCoeff();
  return place.minCoeff() >= -margin && most >= -margin;
}

std::optional<SurfaceFace::Crossing> SurfaceFace::crossing(const Vector3& start, const Vector3& direction) const {
  constexpr int most_iterations = 20;
  constexpr double bulge = 1.1;  // a curved face may leave the sphere around its nodes a little
  const Vector3 to_centre = centre_ - start;
  if (to_centre.cross(direction).norm() > bulge * radius_) {
    return std::nullopt;
  }
  FacePlace place = FacePlace::Constant(is_triangle() ? 1.0 / 3 : 0.5);
  double distance = direction.dot(to_centre);
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Spot spot = at(place);
    const Vector3 miss = spot.position - start - distance * direction;
    if (miss.norm() <= 1e-12 * (radius_ + start.norm())) {  // above the rounding of places far from the origin
      return contains(place) ? std::optional(Crossing{spot, distance}) : std::nullopt;
    }
    Eigen::Matrix3d jacobian;
    jacobian << spot.tangents, -direction;
    const Vector3 step = jacobian.partialPivLu().solve(-miss);
    place += step.head<2>();
    distance += step[2];
    if (!step.allFinite() || place.cwiseAbs().maxCoeff() > 10) {
      break;
    }
  }
  return std::nullopt;
}

}  // namespace idiophone::joints
