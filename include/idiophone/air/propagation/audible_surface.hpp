#pragma once
// What is heard, and what stands in the way: this rank's share of all bodies' surfaces, whether their motion is
// computed or was recorded, and the obstacles.

#include <array>
#include <string>
#include <vector>

#include "idiophone/air/radiation/visibility.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::propagation {

struct AudibleSurface {
  std::vector<mesh::Triangle> triangles;  ///< as places among the vertices here
  std::vector<Index> triangle_ids;        ///< [triangles] global numbers, ascending
  std::vector<Index> vertex_ids;          ///< [vertices] global numbers
  std::vector<Vector3> reference;         ///< [vertices] undeformed, m
  std::vector<double> radii;              ///< [triangles] surface::equivalent_radii where radiation asks for them, m
  double fade_step = 0.0;                 ///< of surface::Emitter, where triangles change over time
  std::vector<std::string> bodies;        ///< [bodies] names
  std::vector<Index> first_triangle;      ///< of each body, and one past the last: [bodies + 1], global
  std::vector<Index> first_vertex;        ///< likewise
  std::vector<std::array<Vector3, 3>> obstacles;  ///< triangles that stand still, m; the same on all ranks
  std::vector<radiation::HalfSpace> half_spaces;  ///< obstacles without bounds; the same on all ranks

  [[nodiscard]] Index global_triangles() const { return first_triangle.back(); }
  [[nodiscard]] Index global_vertices() const { return first_vertex.back(); }
};

/// Global vertex numbers of this rank's triangles, [3 x triangles].
[[nodiscard]] std::vector<Index> global_corners(const AudibleSurface& surface);

/// Several surfaces as one: bodies, triangles and vertices of the first, then those of the second, ...
/// @param surfaces  at least one
[[nodiscard]] AudibleSurface joined(const std::vector<const AudibleSurface*>& surfaces);

}  // namespace idiophone::propagation
