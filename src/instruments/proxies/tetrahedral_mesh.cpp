#include "idiophone/instruments/proxies/tetrahedral_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>
#include <utility>

namespace idiophone::proxies {

namespace {

using Triangle = std::array<Index, 3>;
using Tetrahedron = std::array<Index, 4>;

struct Face {
  Triangle sorted{};
  Triangle outward{};
};

/// The face opposite to a corner, turned away from it.
Face face_opposite(const std::vector<Vector3>& nodes, const Tetrahedron& tetrahedron, std::size_t corner) {
  Face face;
  for (std::size_t i = 0; i < 3; ++i) {
    face.outward[i] = tetrahedron[(corner + 1 + i) % 4];
  }
  const Vector3& a = nodes[face.outward[0]];
  const Vector3 normal = (nodes[face.outward[1]] - a).cross(nodes[face.outward[2]] - a);
  if (normal.dot(nodes[tetrahedron[corner]] - a) > 0.0) {
    std::swap(face.outward[1], face.outward[2]);
  }
  face.sorted = face.outward;
  std::ranges::sort(face.sorted);
  return face;
}

/// Numbers the nodes of a grid, x first.
struct Grid {
  std::array<int, 3> cells;
  std::array<int, 3> nodes;  ///< along each axis

  Grid(const std::array<int, 3>& cell_counts, Seam seam) : cells(cell_counts), nodes(cell_counts) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      nodes[axis] += axis == 0 && seam == Seam::closed ? 0 : 1;
    }
  }

  [[nodiscard]] Index number(const std::array<int, 3>& at) const {
    return at[0] % nodes[0] + nodes[0] * (at[1] + nodes[1] * at[2]);
  }
};

/// Six tetrahedra, each along one way from the first to the last corner of the cell.
void add_cell(const Grid& grid, const std::array<int, 3>& first, std::vector<Tetrahedron>& tetrahedra) {
  std::array<std::size_t, 3> axes = {0, 1, 2};
  do {
    std::array<int, 3> at = first;
    Tetrahedron tetrahedron{grid.number(at)};
    for (std::size_t i = 0; i < 3; ++i) {
      ++at[axes[i]];
      tetrahedron[i + 1] = grid.number(at);
    }
    tetrahedra.push_back(tetrahedron);
  } while (std::ranges::next_permutation(axes).found);
}

}  // namespace

std::vector<Triangle> exterior_triangles(const std::vector<Vector3>& nodes,
                                         const std::vector<Tetrahedron>& tetrahedra) {
  std::vector<Face> faces;
  for (const Tetrahedron& tetrahedron : tetrahedra) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      faces.push_back(face_opposite(nodes, tetrahedron, corner));
    }
  }
  std::ranges::sort(faces, {}, &Face::sorted);
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool is_shared = (i > 0 && faces[i - 1].sorted == faces[i].sorted) ||
                           (i + 1 < faces.size() && faces[i + 1].sorted == faces[i].sorted);
    if (!is_shared) {
      triangles.push_back(faces[i].outward);
    }
  }
  return triangles;
}

TetrahedralMesh grid_mesh(const std::array<int, 3>& cells, const std::function<Vector3(const Vector3&)>& place,
                          Seam seam) {
  if (std::ranges::min(cells) < 1 || (seam == Seam::closed && cells[0] < 3)) {
    throw std::invalid_argument("a grid has at least one cell along each axis, and three around a closed seam");
  }
  const Grid grid(cells, seam);
  TetrahedralMesh mesh;
  for (int z = 0; z < grid.nodes[2]; ++z) {
    for (int y = 0; y < grid.nodes[1]; ++y) {
      for (int x = 0; x < grid.nodes[0]; ++x) {
        const auto share = [&](int at, std::size_t axis) { return static_cast<double>(at) / cells[axis]; };
        mesh.nodes.push_back(place({share(x, 0), share(y, 1), share(z, 2)}));
      }
    }
  }
  for (int z = 0; z < cells[2]; ++z) {
    for (int y = 0; y < cells[1]; ++y) {
      for (int x = 0; x < cells[0]; ++x) {
        add_cell(grid, {x, y, z}, mesh.tetrahedra);
      }
    }
  }
  mesh.surface = exterior_triangles(mesh.nodes, mesh.tetrahedra);
  return mesh;
}

}  // namespace idiophone::proxies
