#include "idiophone/source/audible_surface.hpp"

#include <algorithm>
#include <limits>

#include "idiophone/contact/outline.hpp"
#include "idiophone/parallel/reduce.hpp"

namespace idiophone::source {

namespace {

template <class Value>
void append(std::vector<Value>& values, const std::vector<Value>& more) {
  values.insert(values.end(), more.begin(), more.end());
}

/// Appends numbers that are counted from `offset` on.
void append_shifted(std::vector<Index>& numbers, const std::vector<Index>& more, Index offset) {
  std::ranges::transform(more, std::back_inserter(numbers), [offset](Index number) { return number + offset; });
}

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

std::vector<Index> global_corners(const AudibleSurface& surface) {
  std::vector<Index> corners;
  for (const mesh::Triangle& triangle : surface.triangles) {
    for (const Index vertex : triangle) {
      corners.push_back(surface.vertex_ids[vertex]);
    }
  }
  return corners;
}

AudibleSurface audible_surface(const Preparation& ready, MPI_Comm communicator) {
  const mesh::Part& part = ready.part;
  AudibleSurface surface{.triangles = part.surface,
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

AudibleSurface joined(const std::vector<const AudibleSurface*>& surfaces) {
  AudibleSurface all;
  all.first_triangle = all.first_vertex = {0};
  for (const AudibleSurface* surface : surfaces) {
    const auto vertices_here = static_cast<Index>(all.reference.size());
    for (const auto& [i, j, k] : surface->triangles) {
      all.triangles.push_back({i + vertices_here, j + vertices_here, k + vertices_here});
    }
    const Index triangle = all.global_triangles();
    const Index vertex = all.global_vertices();
    append_shifted(all.triangle_ids, surface->triangle_ids, triangle);
    append_shifted(all.vertex_ids, surface->vertex_ids, vertex);
    append(all.reference, surface->reference);
    append(all.radii, surface->radii);
    append(all.bodies, surface->bodies);
    all.first_triangle.pop_back();
    all.first_vertex.pop_back();
    append_shifted(all.first_triangle, surface->first_triangle, triangle);
    append_shifted(all.first_vertex, surface->first_vertex, vertex);
    append(all.obstacles, surface->obstacles);
    append(all.half_spaces, surface->half_spaces);
  }
  return all;
}

}  // namespace idiophone::source
