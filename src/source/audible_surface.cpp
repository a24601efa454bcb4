#include "idiophone/source/audible_surface.hpp"

#include "idiophone/contact/outline.hpp"

namespace idiophone::source {

std::vector<Vector3> vertex_positions(const mesh::Part& part) {
  std::vector<Vector3> positions;
  for (const Index node : part.vertices) {
    positions.push_back(part.reference[static_cast<std::size_t>(node)]);
  }
  return positions;
}

std::vector<Index> global_corners(const AudibleSurface& surface) {
  std::vector<Index> corners;
  for (const mesh::Triangle& triangle : surface.triangles) {
    for (const Index vertex : triangle) {
      corners.push_back(surface.vertex_ids[static_cast<std::size_t>(vertex)]);
    }
  }
  return corners;
}

AudibleSurface audible_surface(const Preparation& ready) {
  const mesh::Part& part = ready.part;
  AudibleSurface surface{.triangles = part.surface,
                         .triangle_ids = part.triangle_ids,
                         .vertex_ids = part.vertex_ids,
                         .reference = vertex_positions(part),
                         .radii = ready.radii,
                         .first_triangle = ready.offsets.triangles,
                         .obstacles = {},
                         .half_spaces = {}};
  for (const contact::RigidShape& shape : ready.partners.shapes) {
    const auto triangles = contact::outline(shape);
    surface.obstacles.insert(surface.obstacles.end(), triangles.begin(), triangles.end());
    if (triangles.empty()) {
      surface.half_spaces.push_back({shape.planes.front().point, shape.planes.front().normal});
    }
  }
  return surface;
}

}  // namespace idiophone::source
