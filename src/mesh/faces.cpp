#include "faces.hpp"

#include <algorithm>
#include <tuple>

namespace idiophone::mesh {

namespace {

/// A face's places among its element's nodes: three corners seen counter-clockwise from outside, then, in a tet10, the
/// middles of the edges from the first to the second, the second to the third, and the third to the first.
using FaceNodes = std::array<std::size_t, 6>;
constexpr std::array<FaceNodes, 4> faces = {
    {{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {0, 3, 2, 7, 9, 6}}};

/// The same triangle and orientation, smallest node first.
Triangle smallest_first(Triangle triangle) {
  std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
  return triangle;
}

void append_triangles(const Mesh& mesh, const Face& face, std::vector<Triangle>& triangles) {
  const auto nodes = mesh.element_nodes(face.element);
  const auto& [a, b, c, ab, bc, ca] = faces[static_cast<std::size_t>(face.side)];
  if (mesh.element == ElementType::tet4) {
    triangles.push_back(smallest_first({nodes[a], nodes[b], nodes[c]}));
    return;
  }
  triangles.push_back(smallest_first({nodes[a], nodes[ab], nodes[ca]}));
  triangles.push_back(smallest_first({nodes[ab], nodes[b], nodes[bc]}));
  triangles.push_back(smallest_first({nodes[ca], nodes[bc], nodes[c]}));
  triangles.push_back(smallest_first({nodes[ab], nodes[bc], nodes[ca]}));
}

}  // namespace

std::vector<Face> sorted_faces(const Mesh& mesh) {
  std::vector<Face> result;
  result.reserve(4 * static_cast<std::size_t>(mesh.element_count()));
  for (Index element = 0; element < mesh.element_count(); ++element) {
    const auto nodes = mesh.element_nodes(element);
    for (Index side = 0; side < 4; ++side) {
      const auto& face = faces[static_cast<std::size_t>(side)];
      Triangle corners = {nodes[face[0]], nodes[face[1]], nodes[face[2]]};
      std::ranges::sort(corners);
      result.push_back({.corners = corners, .element = element, .side = side});
    }
  }
  std::ranges::sort(result, {}, [](const Face& face) { return std::tie(face.corners, face.element); });
  return result;
}

std::vector<Triangle> exterior_triangles(const Mesh& mesh) {
  const auto all = sorted_faces(mesh);
  std::vector<Triangle> triangles;
  for (auto first = all.begin(); first != all.end();) {
    const auto next = std::find_if(first, all.end(), [&](const Face& face) { return face.corners != first->corners; });
    if (next - first == 1) {
      append_triangles(mesh, *first, triangles);
    }
    first = next;
  }
  std::ranges::sort(triangles);
  return triangles;
}

}  // namespace idiophone::mesh
