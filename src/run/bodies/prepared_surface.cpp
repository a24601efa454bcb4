#include "idiophone/run/bodies/prepared_surface.hpp"

#include <algorithm>
#include <limits>

#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/solids/contact/outline.hpp"

namespace idiophone::bodies {

namespace {

/// First global vertex of each body, and one past the last. A body's vertices are numbered together, after those of
/// the bodies before it. Collective.
std::vector<Index> first_vertices(const mesh::Part& part, MPI_Comm communicator) {
  std::vector<Index> first(part.bodies.size(), std::numeric_limits<Index>::max());
  for (std::size_t t = 0; t < part.surface.size(); ++t) {
    for (const Index vertex : part.surface[t]) {
      first[part.triangle_body[t]] = std::min(first[part.triangle_body[t]], part.vertex_ids[vertex]);
    }
  }
  parallel::reduce(first, MPI_MIN, communicator);
  first.push_back(part.global_vertices);
  return first;
}

/// Undeformed positions of this rank's surface vertices, [vertices] m.
std::vector<Vector3> vertex_positions(const mesh::Part& part) {
  std::vector<Vector3> positions;
  for (const Index node : part.vertices) {
    positions.push_back(part.reference[node]);
  }
  return positions;
}

}  // namespace

propagation::AudibleSurface audible_surface(const Preparation& ready, MPI_Comm communicator) {
  const mesh::Part& part = ready.part;
  propagation::AudibleSurface surface{.triangles = part.surface,
                                      .triangle_ids = part.triangle_ids,
                                      .vertex_ids = part.vertex_ids,
                                      .reference = vertex_positions(part),
                                      .radii = ready.radii,
                                      .bodies = {},
                                      .first_triangle = ready.offsets.triangles,
                                      .first_vertex = first_vertices(part, communicator),
                                      .obstacles = {},
                                      .half_spaces = {}};
  std::ranges::transform(ready.scene.bodies, std::back_inserter(surface.bodies), &scene::Body::name);
  for (const contact::RigidShape& shape : ready.contact_surfaces.shapes) {
    const auto triangles = contact::outline(shape);
    surface.obstacles.insert(surface.obstacles.end(), triangles.begin(), triangles.end());
    if (triangles.empty()) {
      surface.half_spaces.push_back({shape.planes.front().point, shape.planes.front().normal});
    }
  }
  return surface;
}

}  // namespace idiophone::bodies
