#include "idiophone/solids/mesh/face_shares.hpp"

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

/// A node of a quadrilateral in the quadrature of the spectral elements.
struct QuadratureNode {
  double weight = 0.0;
  Vector3 area = Vector3::Zero();  ///< of the face for a weight of 1, outwards, m2
};

/// [nodes of the face]
std::vector<QuadratureNode> nodes_of_quadrilateral(const Mesh& mesh, const ElementFace& face) {
  const element::ReferenceElement& reference = element::reference(mesh.element);
  const element::Face& of_element = reference.faces[face.side];
  const auto [plane, thickness] = element::orders(mesh.element);
  const std::array<int, 3> orders = {plane, plane, thickness};
  const int across = direction_across(reference, of_element), first = (across + 1) % 3, second = (across + 2) % 3;
  const double outwards = reference.nodes[of_element.nodes[0]][across] > 0 ? 1.0 : -1.0;
  const auto nodes = mesh.element_nodes(face.element);
  Eigen::Matrix3Xd positions(3, std::ssize(nodes));
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    positions.col(static_cast<Eigen::Index>(a)) = mesh.nodes[nodes[a]];
  }
  std::vector<QuadratureNode> result;
  for (const int place : of_element.nodes) {
    const Vector3& xi = reference.nodes[place];
    const Eigen::Matrix3d jacobian = positions * element::shape_gradients(mesh.element, xi);
    result.push_back({lobatto_weight(orders.at(first), xi[first]) * lobatto_weight(orders.at(second), xi[second]),
                      outwards * jacobian.col(first).cross(jacobian.col(second))});
  }
  return result;
}

std::vector<double> shares_of_quadrilateral(const Mesh& mesh, const ElementFace& face) {
  std::vector<double> areas;  // m2
  for (const auto& [weight, area] : nodes_of_quadrilateral(mesh, face)) {
    areas.push_back(weight * area.norm());
  }
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  std::ranges::transform(areas, areas.begin(), [&](double part) { return part / area; });
  return areas;
}

std::vector<Vector3> areas_of_quadrilateral(const Mesh& mesh, const ElementFace& face) {
  std::vector<Vector3> areas;
  for (const auto& [weight, area] : nodes_of_quadrilateral(mesh, face)) {
    areas.emplace_back(weight * area);
  }
  return areas;
}

/// The area of the straight triangles of a face, by its shares.
std::vector<Vector3> areas_of_triangle(const Mesh& mesh, const ElementFace& face) {
  std::vector<Triangle> triangles;
  append_triangles(mesh, face, triangles);
  Vector3 whole = Vector3::Zero();
  for (const auto& [a, b, c] : triangles) {
    whole += 0.5 * (mesh.nodes[b] - mesh.nodes[a]).cross(mesh.nodes[c] - mesh.nodes[a]);
  }
  std::vector<Vector3> areas;
  for (const double share : face_shares(mesh, face)) {
    areas.emplace_back(share * whole);
  }
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

std::vector<Vector3> face_areas(const Mesh& mesh, const ElementFace& face) {
  switch (mesh.element.kind) {
    case element::Kind::tet4:
    case element::Kind::tet10:
      return areas_of_triangle(mesh, face);
    case element::Kind::hex:
      return areas_of_quadrilateral(mesh, face);
  }
  element::unknown_kind();
}

}  // namespace idiophone::mesh
