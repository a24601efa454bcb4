#include "idiophone/air/propagation/audible_surface.hpp"

#include <algorithm>

namespace idiophone::propagation {

namespace {

template <class Value>
void append(std::vector<Value>& values, const std::vector<Value>& more) {
  values.insert(values.end(), more.begin(), more.end());
}

/// Appends numbers that are counted from `offset` on.
void append_shifted(std::vector<Index>& numbers, const std::vector<Index>& more, Index offset) {
  std::ranges::transform(more, std::back_inserter(numbers), [offset](Index number) { return number + offset; });
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
    all.fade_step = std::max(all.fade_step, surface->fade_step);
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

}  // namespace idiophone::propagation
