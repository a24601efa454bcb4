#include "idiophone/foundation/element/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "hexahedra.hpp"
#include "idiophone/foundation/element/tetrahedra.hpp"

namespace idiophone::element {

namespace {

constexpr int tetrahedron_corners = 4;

Barycentric barycentric(const Vector3& xi) {
  return {1.0 - xi.sum(), xi[0], xi[1], xi[2]};
}

Vector3 reference_place(const Barycentric& place) {
  return {place[1], place[2], place[3]};
}

template <class Tetrahedron>
Eigen::VectorXd functions(const Barycentric& place) {
  Eigen::VectorXd values(Tetrahedron::nodes);
  for (int a = 0; a < Tetrahedron::nodes; ++a) {
    values[a] = Tetrahedron::shape(place, a);
  }
  return values;
}

template <class Tetrahedron>
Eigen::MatrixX3d gradients(const Barycentric& place) {
  Eigen::MatrixX3d values(Tetrahedron::nodes, 3);
  for (int a = 0; a < Tetrahedron::nodes; ++a) {
    for (int k = 0; k < 3; ++k) {
      values(a, k) = Tetrahedron::gradient(place, a, k);
    }
  }
  return values;
}

std::vector<Vector3> node_places(int count) {
  std::vector<Vector3> places = {Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
  for (const auto& [i, j] : tetrahedron_edges) {
    const Vector3 middle = (places[i] + places[j]) / 2;
    places.push_back(middle);
  }
  places.resize(count);
  return places;
}

template <class Tetrahedron>
Face face(const std::array<int, 6>& places) {
  Face result;
  result.corners.assign(places.begin(), places.begin() + 3);
  std::ranges::copy_if(places, std::back_inserter(result.nodes), [](int node) { return node < Tetrahedron::nodes; });
  for (const auto& [a, b, c] : Tetrahedron::face_triangles) {
    result.triangles.push_back({places[a], places[b], places[c]});
  }
  return result;
}

template <class Tetrahedron>
ReferenceElement tetrahedron(Type type, int order, const DrawnElement& drawn) {
  ReferenceElement result;
  result.type = type;
  result.nodes = node_places(Tetrahedron::nodes);
  result.corners = {0, 1, 2, 3};
  result.edges.assign(tetrahedron_edges.begin(), tetrahedron_edges.end());
  std::ranges::transform(tetrahedron_faces, std::back_inserter(result.faces), face<Tetrahedron>);
  result.straight_tetrahedra.assign(Tetrahedron::straight_tetrahedra.begin(), Tetrahedron::straight_tetrahedra.end());
  for (int q = 0; q < Tetrahedron::points; ++q) {
    const Barycentric& place = Tetrahedron::places[q];
    result.quadrature.push_back({reference_place(place), Tetrahedron::weights[q], gradients<Tetrahedron>(place)});
  }
  for (int corner = 0; corner < tetrahedron_corners; ++corner) {
    result.corner_gradients.push_back(gradients<Tetrahedron>(barycentric(result.nodes[corner])));
  }
  result.regular_jacobian = 1 / std::numbers::sqrt2;
  result.gmsh = {"tetrahedron", order, {Tetrahedron::gmsh_nodes.begin(), Tetrahedron::gmsh_nodes.end()}};
  result.drawn = drawn;
  std::vector<int>& cell = result.drawn.cells.emplace_back(Tetrahedron::nodes);
  std::iota(cell.begin(), cell.end(), 0);  // VTK's order is ours
  std::ranges::transform(result.faces, std::back_inserter(result.drawn.faces), &Face::triangles);
  return result;
}

}  // namespace

const ReferenceElement& reference(Type type) {
  static const ReferenceElement linear = tetrahedron<Tet4>(tet4, 1, {"Tetrahedron", 10, {}, {}});
  static const ReferenceElement quadratic = tetrahedron<Tet10>(tet10, 2, {"Tetrahedron_10", 24, {}, {}});
  switch (type.kind) {
    case Kind::tet4:
      return linear;
    case Kind::tet10:
      return quadratic;
    case Kind::hex:
      return hexahedron(type);
  }
  unknown_kind();
}

const DrawnElement& drawn_with(int nodes_per_cell) {
  for (const Type type : {tet4, tet10, hex(lowest_hex_order, lowest_hex_order)}) {
    const DrawnElement& drawn = reference(type).drawn;
    if (drawn.nodes_per_cell() == nodes_per_cell) {
      return drawn;
    }
  }
  throw std::runtime_error(fmt::format("no element is drawn with cells of {} nodes", nodes_per_cell));
}

Eigen::VectorXd shape_functions(Type type, const Vector3& xi) {
  switch (type.kind) {
    case Kind::tet4:
      return functions<Tet4>(barycentric(xi));
    case Kind::tet10:
      return functions<Tet10>(barycentric(xi));
    case Kind::hex:
      return hexahedron_functions(type, xi);
  }
  unknown_kind();
}

Eigen::MatrixX3d shape_gradients(Type type, const Vector3& xi) {
  switch (type.kind) {
    case Kind::tet4:
      return gradients<Tet4>(barycentric(xi));
    case Kind::tet10:
      return gradients<Tet10>(barycentric(xi));
    case Kind::hex:
      return hexahedron_gradients(type, xi);
  }
  unknown_kind();
}

}  // namespace idiophone::element
