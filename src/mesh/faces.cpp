#include "faces.hpp"

#include <algorithm>
#include <tuple>

#include "idiophone/element/reference.hpp"

namespace idiophone::mesh {

namespace {

/// The same triangle and orientation, smallest node first.
Triangle smallest_first(Triangle triangle) {
  std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
  return triangle;
}

void append_triangles(const Mesh& mesh, const ElementFace& face, std::vector<Triangle>& triangles) {
  const auto nodes = mesh.element_nodes(face.element);
  for (const auto& [a, b, c] : element::reference(mesh.element).faces[face.side].triangles) {
    triangles.push_back(smallest_first({nodes[a], nodes[b], nodes[c]}));
  }
}

}  // namespace

std::vector<ElementFace> sorted_faces(const Mesh& mesh) {
  const auto& faces = element::reference(mesh.element).faces;
  std::vector<ElementFace> result;
  result.reserve(faces.size() * mesh.element_count());
  for (Index element = 0; element < mesh.element_count(); ++element) {
    const auto nodes = mesh.element_nodes(element);
    for (Index side = 0; side < std::ssize(faces); ++side) {
      const std::vector<int>& places = faces[side].corners;
      std::array<Index, 4> corners = {-1, -1, -1, -1};
      std::ranges::transform(places, corners.begin(), [&](int place) { return nodes[place]; });
      std::ranges::sort(corners);
      result.push_back({.corners = corners, .element = element, .side = side});
    }
  }
  std::ranges::sort(result, {}, [](const ElementFace& face) { return std::tie(face.corners, face.element); });
  return result;
}

std::vector<Triangle> exterior_triangles(const Mesh& mesh) {
  const auto all = sorted_faces(mesh);
  std::vector<Triangle> triangles;
  for (auto first = all.begin(); first != all.end();) {
    const auto next =
        std::find_if(first, all.end(), [&](const ElementFace& face) { return face.corners != first->corners; });
    if (next - first == 1) {
      append_triangles(mesh, *first, triangles);
    }
    first = next;
  }
  std::ranges::sort(triangles);
  return triangles;
}

}  // namespace idiophone::mesh
