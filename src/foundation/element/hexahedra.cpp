#include "hexahedra.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "idiophone/foundation/element/lagrange.hpp"
#include "idiophone/foundation/element/lobatto.hpp"

namespace idiophone::element {

namespace {

using GridIndex = std::array<int, 3>;  ///< (i, j, k)

/// The nodes of an element as a grid.
struct Grid {
  explicit Grid(Type type) : orders{type.plane, type.plane, type.thickness} {}

  [[nodiscard]] int node(const GridIndex& at) const {
    return at[0] + (orders[0] + 1) * (at[1] + (orders[1] + 1) * at[2]);
  }

  /// Calls visit(place) for the places from `begin` up to and without `end`, the first index fastest.
  template <class Visitor>
  static void for_each(const GridIndex& begin, const GridIndex& end, Visitor visit) {
    for (int k = begin[2]; k < end[2]; ++k) {
      for (int j = begin[1]; j < end[1]; ++j) {
        for (int i = begin[0]; i < end[0]; ++i) {
          visit(GridIndex{i, j, k});
        }
      }
    }
  }
  template <class Visitor>
  void for_each_node(Visitor visit) const {
    for_each({0, 0, 0}, {orders[0] + 1, orders[1] + 1, orders[2] + 1}, visit);
  }

  GridIndex orders;
};

/// Corners in gmsh's and VTK's order, as places in a cube of one cell.
constexpr std::array<GridIndex, 8> cube_corners = {
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

constexpr std::array<std::array<int, 2>, 12> cube_edges = {
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// The polynomials of the three directions at a point.
std::array<Lagrange, 3> lines_at(const Grid& grid, const Vector3& xi) {
  const auto line = [&](int d) { return lagrange(lobatto(grid.orders[d]).nodes, xi[d]); };
  return {line(0), line(1), line(2)};
}

GridIndex along(int direction) {
  GridIndex unit = {0, 0, 0};
  unit[direction] = 1;
  return unit;
}

GridIndex sum(const GridIndex& a, const GridIndex& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// An end of a direction's interval: -1 or 1.
enum class End { lower, upper };

/// The face where xi_direction is at one end. Its cells are cut from their lowest to their highest node, as the
/// straight tetrahedra cut them.
Face face(const Grid& grid, int direction, End end_of_direction) {
  const bool upper = end_of_direction == End::upper;
  // First and second direction within the face, such that their cross product points out of the element.
  const int first = upper ? (direction + 1) % 3 : (direction + 2) % 3;
  const int second = upper ? (direction + 2) % 3 : (direction + 1) % 3;
  GridIndex begin = {0, 0, 0};
  GridIndex end = {grid.orders[0] + 1, grid.orders[1] + 1, grid.orders[2] + 1};
  begin[direction] = upper ? grid.orders[direction] : 0;
  end[direction] = begin[direction] + 1;
  const auto corner = [&](int along_first, int along_second) {
    GridIndex at = begin;
    at[first] = along_first * grid.orders[first];
    at[second] = along_second * grid.orders[second];
    return grid.node(at);
  };
  Face result;
  result.corners = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
  result.nodes = result.corners;
  Grid::for_each(begin, end, [&](const GridIndex& at) {
    if (std::ranges::find(result.corners, grid.node(at)) == result.corners.end()) {
      result.nodes.push_back(grid.node(at));
    }
    if (at[first] < grid.orders[first] && at[second] < grid.orders[second]) {
      const GridIndex ahead = sum(at, along(first));
      const GridIndex beside = sum(at, along(second));
      const int highest = grid.node(sum(ahead, along(second)));
      result.triangles.push_back({grid.node(at), grid.node(ahead), highest});
      result.triangles.push_back({grid.node(at), highest, grid.node(beside)});
    }
  });
  return result;
}

/// Six tetrahedra in each cell: one for each order in which the directions lead from its lowest to its highest node.
std::vector<std::array<int, 4>> tetrahedra(const Grid& grid) {
  std::vector<std::array<int, 4>> result;
  Grid::for_each({0, 0, 0}, grid.orders, [&](const GridIndex& low) {
    GridIndex directions = {0, 1, 2};
    do {
      const GridIndex second = sum(low, along(directions[0]));
      const GridIndex third = sum(second, along(directions[1]));
      std::array<int, 4> nodes = {grid.node(low), grid.node(second), grid.node(third),
                                  grid.node(sum(third, along(directions[2])))};
      if ((directions[0] + 1) % 3 != directions[1]) {
        std::swap(nodes[1], nodes[2]);
      }
      result.push_back(nodes);
    } while (std::next_permutation(directions.begin(), directions.end()));
  });
  return result;
}

/// Of the cells that hexahedra are drawn with (DrawnElement::faces).
std::vector<std::vector<std::array<int, 3>>> cell_faces() {
  const Grid cell({Kind::hex, 1, 1});
  std::array<int, cube_corners.size()> places{};  // in VTK's order of each node
  for (std::size_t corner = 0; corner < places.size(); ++corner) {
    places.at(cell.node(cube_corners.at(corner))) = static_cast<int>(corner);
  }
  std::vector<std::vector<std::array<int, 3>>> result;
  for (int direction = 0; direction < 3; ++direction) {
    for (const End end : {End::lower, End::upper}) {
      auto& triangles = result.emplace_back();
      for (const auto& [a, b, c] : face(cell, direction, end).triangles) {
        triangles.push_back({places.at(a), places.at(b), places.at(c)});
      }
    }
  }
  return result;
}

ReferenceElement make_row(Type type) {
  const Grid grid(type);
  const std::array<const Lobatto*, 3> rules = {&lobatto(type.plane), &lobatto(type.plane), &lobatto(type.thickness)};
  ReferenceElement result;
  result.type = type;
  grid.for_each_node([&](const GridIndex& at) {
    Vector3 xi;
    double weight = 1.0;
    for (int d = 0; d < 3; ++d) {
      xi[d] = rules[d]->nodes[at[d]];
      weight *= rules[d]->weights[at[d]];
    }
    result.nodes.push_back(xi);
    result.quadrature.push_back({xi, weight, hexahedron_gradients(type, xi)});
  });
  for (const GridIndex& corner : cube_corners) {
    result.corners.push_back(
        grid.node({corner[0] * grid.orders[0], corner[1] * grid.orders[1], corner[2] * grid.orders[2]}));
    result.corner_gradients.push_back(hexahedron_gradients(type, result.nodes[result.corners.back()]));
  }
  for (const auto& [a, b] : cube_edges) {
    result.edges.push_back({result.corners[a], result.corners[b]});
  }
  for (int direction = 0; direction < 3; ++direction) {
    result.faces.push_back(face(grid, direction, End::lower));
    result.faces.push_back(face(grid, direction, End::upper));
  }
  result.straight_tetrahedra = tetrahedra(grid);
  result.regular_jacobian = 1.0 / 8;
  if (type.plane == type.thickness) {
    result.gmsh = {"hexahedron", type.plane, gmsh_hexahedron_nodes(type.plane)};
  }
  result.drawn = {"Hexahedron", 12, {}, cell_faces()};
  Grid::for_each({0, 0, 0}, grid.orders, [&](const GridIndex& low) {
    auto& cell = result.drawn.cells.emplace_back();
    std::ranges::transform(cube_corners, std::back_inserter(cell),
                           [&](const GridIndex& corner) { return grid.node(sum(low, corner)); });
  });
  return result;
}

}  // namespace

const ReferenceElement& hexahedron(Type type) {
  static std::map<std::pair<int, int>, ReferenceElement> rows;
  const std::pair<int, int> orders = {type.plane, type.thickness};
  const auto found = rows.find(orders);
  return found != rows.end() ? found->second : rows.emplace(orders, make_row(type)).first->second;
}

Eigen::VectorXd hexahedron_functions(Type type, const Vector3& xi) {
  const Grid grid(type);
  const auto line = lines_at(grid, xi);
  Eigen::VectorXd values(node_count(type));
  grid.for_each_node([&](const GridIndex& at) {
    values[grid.node(at)] = line[0].values[at[0]] * line[1].values[at[1]] * line[2].values[at[2]];
  });
  return values;
}

Eigen::MatrixX3d hexahedron_gradients(Type type, const Vector3& xi) {
  const Grid grid(type);
  const auto line = lines_at(grid, xi);
  Eigen::MatrixX3d values(node_count(type), 3);
  grid.for_each_node([&](const GridIndex& at) {
    for (int k = 0; k < 3; ++k) {
      const auto factor = [&](int d) { return (d == k ? line[d].slopes : line[d].values)[at[d]]; };
      values(grid.node(at), k) = factor(0) * factor(1) * factor(2);
    }
  });
  return values;
}

}  // namespace idiophone::element
