#include "idiophone/solids/mesh/faces.hpp"

#include <algorithm>
#include <tuple>

#include "compressed_rows.hpp"
#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::mesh {

namespace {

Index lowest_corner(const Mesh& mesh, const element::Face& face, Index element) {
  const auto nodes = mesh.element_nodes(element);
  return nodes[std::ranges::min(face.corners, {}, [&](int place) { return nodes[place]; })];
}

ElementFace face_of(const Mesh& mesh, Index element, Index side) {
  ElementFace face{.element = element, .side = side};
  face.corners.fill(-1);
  const auto nodes = mesh.element_nodes(element);
  std::ranges::transform(element::reference(mesh.element).faces[side].corners, face.corners.begin(),
                         [&](int place) { return nodes[place]; });
  std::ranges::sort(face.corners);
  return face;
}

/// [nodes] lists of element * sides + side, of the faces whose lowest corner the node is.
CompressedRows faces_at_nodes(const Mesh& mesh) {
  const auto& faces = element::reference(mesh.element).faces;
  const auto sides = static_cast<Index>(faces.size());
  return {static_cast<Index>(mesh.nodes.size()), [&](auto list) {
            for (Index element = 0; element < mesh.element_count(); ++element) {
              for (Index side = 0; side < sides; ++side) {
                list(lowest_corner(mesh, faces[side], element), element * sides + side);
              }
            }
          }};
}

}  // namespace

void turn_smallest_first(Triangle& triangle) {
  std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
}

void append_triangles(const Mesh& mesh, const ElementFace& face, std::vector<Triangle>& triangles) {
  const auto nodes = mesh.element_nodes(face.element);
  for (const auto& [a, b, c] : element::reference(mesh.element).faces[face.side].triangles) {
    turn_smallest_first(triangles.emplace_back(Triangle{nodes[a], nodes[b], nodes[c]}));
  }
}

void for_each_shared_face(const Mesh& mesh, const std::function<void(std::span<const ElementFace>)>& visit) {
  const auto sides = static_cast<Index>(element::reference(mesh.element).faces.size());
  const CompressedRows lists = faces_at_nodes(mesh);
  std::vector<ElementFace> here;
  for (Index node = 0; node < std::ssize(mesh.nodes); ++node) {
    here.clear();
    for (const Index number : lists[node]) {
      here.push_back(face_of(mesh, number / sides, number % sides));
    }
    std::ranges::sort(here, {}, [](const ElementFace& face) { return std::tie(face.corners, face.element); });
    for (auto first = here.begin(); first != here.end();) {
      const auto next =
          std::find_if(first, here.end(), [&](const ElementFace& face) { return face.corners != first->corners; });
      visit({first, next});
      first = next;
    }
  }
}

std::vector<Triangle> exterior_triangles(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  for_each_shared_face(mesh, [&](std::span<const ElementFace> faces) {
    if (faces.size() == 1) {
      append_triangles(mesh, faces.front(), triangles);
    }
  });
  std::ranges::sort(triangles);
  return triangles;
}

}  // namespace idiophone::mesh
