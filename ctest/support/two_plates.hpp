#pragma once
// Two square plates, one above the other, each a body of two triangles; the triangles are dealt to the ranks.

#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/air/surface/surface_motion.hpp"
#include "shared_folder.hpp"

namespace idiophone::support {

/// The lower plate is at z = 0, the upper one at z = 1, both 1 m wide and centred at x = y = 0.
inline propagation::AudibleSurface two_plates() {
  propagation::AudibleSurface surface;
  surface.bodies = {"lower", "upper"};
  surface.first_triangle = {0, 2, 4};
  surface.first_vertex = {0, 4, 8};
  for (Index vertex = 0; vertex < 8; ++vertex) {  // every rank has all vertices
    surface.vertex_ids.push_back(vertex);
    surface.reference.emplace_back((vertex & 1) - 0.5, (vertex >> 1 & 1) - 0.5, vertex >> 2);
  }
  for (Index triangle = 0; triangle < 4; ++triangle) {
    if (triangle % ranks() == rank()) {
      const Index first = triangle < 2 ? 0 : 4;
      surface.triangle_ids.push_back(triangle);
      surface.triangles.push_back(triangle % 2 == 0 ? mesh::Triangle{first, first + 1, first + 2}
                                                    : mesh::Triangle{first + 1, first + 3, first + 2});
    }
  }
  return surface;
}

/// Both at rest, the upper one shifted along x, m.
inline surface::SurfaceMotion at_rest(const propagation::AudibleSurface& surface, double shift) {
  surface::SurfaceMotion motion;
  motion.pressure.assign(padded(surface.triangles.size()), 0.0);
  for (std::size_t vertex = 0; vertex < surface.reference.size(); ++vertex) {
    const Vector3 place = surface.reference[vertex] + Vector3(surface.vertex_ids[vertex] < 4 ? 0.0 : shift, 0.0, 0.0);
    motion.position.insert(motion.position.end(), place.begin(), place.end());
  }
  motion.position.resize(surface::SurfaceMotion::position_length(surface.reference.size()));
  return motion;
}

}  // namespace idiophone::support
