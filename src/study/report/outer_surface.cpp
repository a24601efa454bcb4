#include "outer_surface.hpp"

#include <map>

#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::report {

std::vector<Triangle> surface_of(const results::FramedBody& body) {
  struct Face {
    int cells = 0;
    std::vector<Triangle> triangles;
  };
  std::map<std::vector<std::int32_t>, Face> faces;  // by their sorted nodes
  const auto& faces_of_cell = element::drawn_with(static_cast<int>(body.cell_nodes)).faces;
  for (std::size_t first = 0; first + body.cell_nodes <= body.cells.size(); first += body.cell_nodes) {
    for (const auto& places : faces_of_cell) {
      std::vector<std::int32_t> nodes;
      std::vector<Triangle> triangles;
      for (const auto& [a, b, c] : places) {
        triangles.push_back({body.cells[first + a], body.cells[first + b], body.cells[first + c]});
        nodes.insert(nodes.end(), triangles.back().begin(), triangles.back().end());
      }
      keep_each_once(nodes);
      Face& face = faces[nodes];
      ++face.cells;
      face.triangles = triangles;
    }
  }
  std::vector<Triangle> surface;
  for (const auto& [nodes, face] : faces) {
    if (face.cells == 1) {
      surface.insert(surface.end(), face.triangles.begin(), face.triangles.end());
    }
  }
  return surface;
}

}  // namespace idiophone::report
