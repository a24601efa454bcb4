#include "part_numbers.hpp"

#include <algorithm>

namespace idiophone::mesh {

void PartNumbers::renumber(Part& part, const NodeDivision& division) const {
  part.global_nodes = all.nodes.back();
  part.global_elements = all.elements.back();
  part.global_triangles = all.triangles.back();
  part.global_vertices = static_cast<Index>(surface_nodes.size());
  std::ranges::for_each(part.node_ids, [&](Index& node) { node = nodes[node]; });
  for (std::size_t ghost = 0; ghost < part.ghost_index.size(); ++ghost) {
    part.ghost_index[ghost] = division.place_on_owner(part.node_ids[part.owned_nodes + ghost]);
  }
  for (std::size_t body = 0; body < part.bodies.size(); ++body) {
    BodyPart& share = part.bodies[body];
    share.first_element = all.elements[body];
    share.global_elements = all.elements[body + 1] - all.elements[body];
    for (Index& element : share.element_ids) {
      element = all.elements[body] + elements[body][element - here.elements[body]];
    }
  }
  for (std::size_t triangle = 0; triangle < part.triangle_ids.size(); ++triangle) {
    const Index body = part.triangle_body[triangle];
    Index& number = part.triangle_ids[triangle];
    number = all.triangles[body] + triangles[body][number - here.triangles[body]];
  }
  std::ranges::transform(part.vertices, part.vertex_ids.begin(), [&](Index vertex) {
    const auto place = std::ranges::lower_bound(surface_nodes, part.node_ids[vertex]);
    return static_cast<Index>(place - surface_nodes.begin());
  });
}

}  // namespace idiophone::mesh
