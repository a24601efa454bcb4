#pragma once
// A cube as a glTF file, as programs for pictures write it: every side has vertices of its own.

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/web/base64.hpp"

namespace idiophone::mesher {

/// The sides of the cube with corners at 0 and 1, as a list of vertices: [3 x 36], three for each triangle.
inline std::vector<float> cube_vertices() {
  std::vector<float> vertices;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const float side : {0.0F, 1.0F}) {
      for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
        std::array<float, 3> place = {};
        place.at(axis) = side;
        place.at((axis + 1) % 3) = static_cast<float>(side > 0 ? u : v);
        place.at((axis + 2) % 3) = static_cast<float>(side > 0 ? v : u);
        vertices.insert(vertices.end(), place.begin(), place.end());
      }
    }
  }
  return vertices;
}

/// The bytes of the vertices.
inline std::string cube_bytes() {
  const std::vector<float> vertices = cube_vertices();
  return {reinterpret_cast<const char*>(vertices.data()), vertices.size() * sizeof(float)};
}

/// @param nodes     as JSON; the cube is mesh 0
/// @param buffer    URI of the bytes; empty: they are in the file
/// @param vertices  used of the 36
inline std::string gltf_cube(const std::string& nodes, const std::string& buffer = "", std::size_t vertices = 36) {
  const std::string bytes = cube_bytes();
  const std::string uri =
      buffer.empty() ? "data:application/octet-stream;base64," + web::base64(std::as_bytes(std::span(bytes))) : buffer;
  return fmt::format(R"({{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}], "nodes": {},
"meshes": [{{"name": "cube", "primitives": [{{"attributes": {{"POSITION": 0}}}}]}}],
"accessors": [{{"bufferView": 0, "componentType": 5126, "count": {}, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]}}],
"bufferViews": [{{"buffer": 0, "byteLength": {}}}], "buffers": [{{"byteLength": {}, "uri": "{}"}}]}})",
                     nodes, vertices, bytes.size(), bytes.size(), uri);
}

}  // namespace idiophone::mesher
