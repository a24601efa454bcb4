#include "block_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "idiophone/foundation/element/lobatto.hpp"
#include "idiophone/solids/mesh/faces.hpp"

namespace idiophone::support {

namespace {

using mesh::Mesh;
using Grid = std::array<int, 3>;

/// Nodes of the cells that have so many steps from node to node along each axis; tet4 uses only every second place.
class NodeGrid {
 public:
  NodeGrid(Mesh& mesh, Vector3 size, const Grid& cells, const Grid& steps)
      : mesh_(mesh), size_(std::move(size)), cells_(cells), steps_(steps) {}

  /// @param place  steps from the origin
  Index node(const Grid& place) {
    const auto [known, fresh] = numbers_.try_emplace(place, static_cast<Index>(mesh_.nodes.size()));
    if (fresh) {
      Vector3 position;
      for (std::size_t i = 0; i < 3; ++i) {
        const int cell = std::min(place[i] / steps_[i], cells_[i] - 1);
        const double inside = element::lobatto(steps_[i]).nodes[place[i] - cell * steps_[i]];
        position[i] = size_[i] * (2 * cell + 1 + inside) / (2.0 * cells_[i]);
      }
      mesh_.nodes.push_back(position);
      add_to_groups(known->second, place);
    }
    return known->second;
  }

 private:
  void add_to_groups(Index number, const Grid& place) {
    const bool x0 = place[0] == 0;
    const bool x1 = place[0] == steps_[0] * cells_[0];
    if (x0) {
      mesh_.groups["x0"].push_back(number);
    }
    if (x1) {
      mesh_.groups["x1"].push_back(number);
    }
    if (x0 || x1 || place[1] == 0 || place[1] == steps_[1] * cells_[1]) {
      mesh_.groups["rim"].push_back(number);
    }
  }

  Mesh& mesh_;
  Vector3 size_;
  Grid cells_;
  Grid steps_;
  std::map<Grid, Index> numbers_;
};

Grid middle(const Grid& a, const Grid& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

void add_tetrahedron(Mesh& mesh, NodeGrid& grid, const std::array<Grid, 4>& corners) {
  for (const Grid& corner : corners) {
    mesh.elements.push_back(grid.node(corner));
  }
  if (mesh.element == element::tet10) {
    for (const auto& [i, j] : {std::array{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}) {
      mesh.elements.push_back(grid.node(middle(corners[i], corners[j])));
    }
  }
}

/// Through-thickness direction along z.
void add_hexahedron(Mesh& mesh, NodeGrid& grid, const Grid& cell) {
  const int p = mesh.element.plane;
  const int q = mesh.element.thickness;
  for (int k = 0; k <= q; ++k) {
    for (int j = 0; j <= p; ++j) {
      for (int i = 0; i <= p; ++i) {
        mesh.elements.push_back(grid.node({p * cell[0] + i, p * cell[1] + j, q * cell[2] + k}));
      }
    }
  }
}

/// The six tetrahedra of a cell: one for each order in which the axes can be walked from its low to its high corner.
void add_tetrahedra(Mesh& mesh, NodeGrid& grid, const Grid& low) {
  std::array<int, 3> axes = {0, 1, 2};
  do {
    std::array<Grid, 4> corners = {low, low, low, low};
    for (std::size_t step = 0; step < 3; ++step) {
      corners[step + 1] = corners[step];
      corners[step + 1][axes[step]] += 2;
    }
    const bool even = (axes[0] + 1) % 3 == axes[1];
    if (!even) {
      std::swap(corners[1], corners[2]);
    }
    add_tetrahedron(mesh, grid, corners);
  } while (std::next_permutation(axes.begin(), axes.end()));
}

}  // namespace

Mesh block_mesh(element::Type element, const Vector3& size, const Grid& cells) {
  Mesh mesh;
  mesh.element = element;
  const bool hexahedra = element.kind == element::Kind::hex;
  NodeGrid grid(mesh, size, cells, hexahedra ? Grid{element.plane, element.plane, element.thickness} : Grid{2, 2, 2});
  for (int z = 0; z < cells[2]; ++z) {
    for (int y = 0; y < cells[1]; ++y) {
      for (int x = 0; x < cells[0]; ++x) {
        if (hexahedra) {
          add_hexahedron(mesh, grid, {x, y, z});
        } else {
          add_tetrahedra(mesh, grid, {2 * x, 2 * y, 2 * z});
        }
      }
    }
  }
  mesh.surface = mesh::exterior_triangles(mesh);
  return mesh;
}

mesh::Part whole_part(const Mesh& mesh) {
  mesh::Part part;
  part.global_nodes = part.owned_nodes = static_cast<Index>(mesh.nodes.size());
  part.global_elements = mesh.element_count();
  part.reference = mesh.nodes;
  part.first_piece = {0, mesh.piece_count()};
  part.pieces = mesh.pieces;
  part.node_ids.resize(mesh.nodes.size());
  std::iota(part.node_ids.begin(), part.node_ids.end(), 0);
  mesh::BodyPart body;
  body.element = mesh.element;
  body.owned_end = part.owned_nodes;
  body.global_elements = mesh.element_count();
  body.elements = mesh.elements;
  body.element_ids.resize(mesh.element_count());
  std::iota(body.element_ids.begin(), body.element_ids.end(), 0);
  body.owned.assign(body.element_ids.size(), 1);
  body.regions = mesh.regions;
  part.bodies.push_back(std::move(body));
  return part;
}

}  // namespace idiophone::support
