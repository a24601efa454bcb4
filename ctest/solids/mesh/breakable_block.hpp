#pragma once
// A block with fracture surfaces.

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "block_mesh.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/solids/mesh/faces.hpp"

namespace idiophone::mesh {

using Inside = std::function<bool(const Vector3&)>;

inline const Vector3 block_size(0.4, 0.2, 0.2);  // m

inline bool on_x(const Vector3& node) {
  return std::abs(node.x() - block_size.x() / 2) < 1e-9;
}
inline bool on_y(const Vector3& node) {
  return std::abs(node.y() - block_size.y() / 2) < 1e-9;
}

/// A block and its fracture surfaces "0", "1", ...
struct Breakable {
  explicit Breakable(const std::vector<Inside>& surfaces, element::Type element = element::tet10)
      : mesh(support::block_mesh(element, block_size, {4, 2, 2})) {
    body.name = "block";
    body.element = element;
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      name(std::to_string(s));
      for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
        if (surfaces[s](mesh.nodes[node])) {
          mesh.groups[std::to_string(s)].push_back(static_cast<Index>(node));
        }
      }
      add_triangles(std::to_string(s), surfaces[s]);
    }
  }

  /// All triangles whose corners are on a surface.
  void add_triangles(const std::string& group, const Inside& surface) {
    for_each_shared_face(mesh, [&](std::span<const ElementFace> faces) {
      const auto& [none, a, b, c] = faces.front().corners;
      if (surface(mesh.nodes[a]) && surface(mesh.nodes[b]) && surface(mesh.nodes[c])) {
        mesh.group_triangles[group].push_back({b, c, a});
      }
    });
  }

  void name(const std::string& group) {
    body.fracture.push_back({.group = group, .strength = 1e6, .where = {.file = "deck.yaml", .line = 9, .column = 5}});
  }

  [[nodiscard]] std::string refusal() const {
    try {
      static_cast<void>(divide(mesh, body));
      return "";
    } catch (const deck::DeckError& error) {
      return error.what();
    }
  }

  Mesh mesh;
  scene::Body body;
};

}  // namespace idiophone::mesh
