#include <array>

#include "hexahedra.hpp"

namespace idiophone::element {

namespace {

using GridIndex = std::array<int, 3>;  ///< (i, j, k)

/// Of an edge, the place so many of its `order` steps from one end to the other.
GridIndex on_edge(const GridIndex& from, const GridIndex& to, int steps, int order) {
  GridIndex at = from;
  for (int d = 0; d < 3; ++d) {
    at[d] += steps * (to[d] - from[d]) / order;
  }
  return at;
}

/// The corner, moved one step along each edge that leaves it towards one of the others.
template <std::size_t count>
GridIndex inward(const GridIndex& corner, const std::array<GridIndex, count>& others, int order) {
  GridIndex at = corner;
  for (const GridIndex& other : others) {
    const GridIndex step = on_edge(corner, other, 1, order);
    for (int d = 0; d < 3; ++d) {
      at[d] += step[d] - corner[d];
    }
  }
  return at;
}

/// Appends corners, nodes within the edges, and what lies inside, which is a quadrilateral again.
void append_quadrilateral(const std::array<GridIndex, 4>& corners, int order, std::vector<GridIndex>& places) {
  if (order == 0) {
    places.push_back(corners[0]);
    return;
  }
  places.insert(places.end(), corners.begin(), corners.end());
  std::array<GridIndex, 4> inner{};
  for (int a = 0; a < 4; ++a) {
    const GridIndex& next = corners[(a + 1) % 4];
    for (int step = 1; step < order; ++step) {
      places.push_back(on_edge(corners[a], next, step, order));
    }
    inner[a] = inward(corners[a], std::array{next, corners[(a + 3) % 4]}, order);
  }
  if (order >= 2) {
    append_quadrilateral(inner, order - 2, places);
  }
}

/// gmsh's order of the edges and faces of a hexahedron (gmsh's manual, Node ordering).
constexpr std::array<std::array<int, 2>, 12> edges = {
    {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3}, {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}}};
constexpr std::array<std::array<int, 4>, 6> faces = {
    {{0, 3, 2, 1}, {0, 1, 5, 4}, {0, 4, 7, 3}, {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}}};

/// Appends corners, nodes within the edges and within the faces, and what lies inside, which is a hexahedron again.
void append_hexahedron(const std::array<GridIndex, 8>& corners, int order, std::vector<GridIndex>& places) {
  if (order == 0) {
    places.push_back(corners[0]);
    return;
  }
  places.insert(places.end(), corners.begin(), corners.end());
  for (const auto& [a, b] : edges) {
    for (int step = 1; step < order; ++step) {
      places.push_back(on_edge(corners[a], corners[b], step, order));
    }
  }
  if (order < 2) {
    return;
  }
  for (const auto& face : faces) {
    std::array<GridIndex, 4> inner{};
    for (int a = 0; a < 4; ++a) {
      inner[a] = inward(corners[face[a]], std::array{corners[face[(a + 1) % 4]], corners[face[(a + 3) % 4]]}, order);
    }
    append_quadrilateral(inner, order - 2, places);
  }
  std::array<GridIndex, 8> inner{};
  for (int a = 0; a < 8; ++a) {
    const int level = a / 4 * 4;
    inner[a] =
        inward(corners[a], std::array{corners[level + (a + 1) % 4], corners[level + (a + 3) % 4], corners[(a + 4) % 8]},
               order);
  }
  append_hexahedron(inner, order - 2, places);
}

/// Of each place of a grid, the first index fastest, its number in gmsh's list.
std::vector<int> numbers_in(const std::vector<GridIndex>& places, int order) {
  std::vector<int> numbers(places.size());
  for (std::size_t number = 0; number < places.size(); ++number) {
    const auto& [i, j, k] = places[number];
    numbers[i + (order + 1) * (j + (order + 1) * k)] = static_cast<int>(number);
  }
  return numbers;
}

}  // namespace

std::vector<int> gmsh_quadrilateral_nodes(int order) {
  const int n = order;
  std::vector<GridIndex> places;
  append_quadrilateral({{{0, 0, 0}, {n, 0, 0}, {n, n, 0}, {0, n, 0}}}, n, places);
  return numbers_in(places, n);
}

std::vector<int> gmsh_hexahedron_nodes(int order) {
  const int n = order;
  std::vector<GridIndex> places;
  append_hexahedron({{{0, 0, 0}, {n, 0, 0}, {n, n, 0}, {0, n, 0}, {0, 0, n}, {n, 0, n}, {n, n, n}, {0, n, n}}}, n,
                    places);
  return numbers_in(places, n);
}

}  // namespace idiophone::element
