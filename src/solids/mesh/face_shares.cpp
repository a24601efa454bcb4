#include "face_shares.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numeric>

#include "idiophone/foundation/element/lobatto.hpp"
#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::mesh {

namespace {

/// The weight of one of the rule's nodes.
double lobatto_weight(int order, double node) {
  const element::Lobatto& rule = element::lobatto(order);
  Eigen::Index place = 0;
  (rule.nodes.array() - node).abs().minCoeff(&place);
  return rule.weights[place];
}

/// The direction of the reference element in which all nodes of a face have the same coordinate.
int direction_across(const element::ReferenceElement& reference, const element::Face& face) {
  int across = 0;
  const auto is_across = [&](int place) {
    return reference.nodes[place][across] == reference.nodes[face.nodes[0]][across];
  };
  while (!std::ranges::all_of(face.nodes, is_across)) {
    ++across;
  }
  return across;
}

/// By the quadrature of the spectral elements: the weight of a node times the area around it.
std::vector<double> shares_of_quadrilateral(const Mesh& mesh, const ElementFace& face) {
  const element::ReferenceElement& reference = element::reference(mesh.element);
  const element::Face& of_element = reference.faces[face.side];
  const auto [plane, thickness] = element::orders(mesh.element);
  const std::array<int, 3> orders = {plane, plane, thickness};
  const int across = direction_across(reference, of_element), first = (across + 1) % 3, second = (across + 2) % 3;
  const auto nodes = mesh.element_nodes(face.element);
  Eigen::Matrix3Xd positions(3, std::ssize(nodes));
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    positions.col(static_cast<Eigen::Index>(a)) = mesh.nodes[nodes[a]];
  }
  std::vector<double> areas;  // m2
  for (const int place : of_element.nodes) {
    const Vector3& xi = reference.nodes[place];
    const Eigen::Matrix3d jacobian = positions * element::shape_gradients(mesh.element, xi);
    areas.push_back(lobatto_weight(orders.at(first), xi[first]) * lobatto_weight(orders.at(second), xi[second]) *
                    jacobian.col(first).cross(jacobian.col(second)).norm());
  }
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  std::ranges::transform(areas, areas.begin(), [&](double part) { return part / area; });
  return areas;
}

}  // namespace

std::vector<double> face_shares(const Mesh& mesh, const ElementFace& face) {
  switch (mesh.element.kind) {
    case element::Kind::tet4:
      return {1.0 / 3, 1.0 / 3, 1.0 / 3};
    case element::Kind::tet10:
      return {0.0, 0.0, 0.0, 1.0 / 3, 1.0 / 3, 1.0 / 3};
    case element::Kind::hex:
      return shares_of_quadrilateral(mesh, face);
  }
  element::unknown_kind();
}

}  // namespace idiophone::mesh
