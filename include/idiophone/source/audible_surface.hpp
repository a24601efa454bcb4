#pragma once
// What is heard, and what stands in the way: this rank's share of all bodies' surfaces, whether their motion is being
// computed or was recorded, and the obstacles.

#include <vector>

#include "idiophone/mesh/mesh.hpp"
#include "idiophone/radiation/visibility.hpp"
#include "idiophone/source/preparation.hpp"

namespace idiophone::source {

struct AudibleSurface {
  std::vector<mesh::Triangle> triangles;  ///< as places among the vertices here
  std::vector<Index> triangle_ids;        ///< [triangles] global numbers, ascending
  std::vector<Index> vertex_ids;          ///< [vertices] global numbers
  std::vector<Vector3> reference;         ///< [vertices] undeformed, m
  std::vector<double> radii;              ///< [triangles] surface::equivalent_radii where radiation asks for them, m
  std::vector<Index> first_triangle;      ///< of each body, and one past the last: [bodies + 1], global
  std::vector<std::array<Vector3, 3>> obstacles;  ///< triangles that stand still, m; the same on all ranks
  std::vector<radiation::HalfSpace> half_spaces;  ///< obstacles without bounds; the same on all ranks
};

/// Undeformed positions of this rank's surface vertices, [vertices] m.
[[nodiscard]] std::vector<Vector3> vertex_positions(const mesh::Part& part);

/// Global vertex numbers of this rank's triangles, [3 x triangles].
[[nodiscard]] std::vector<Index> global_corners(const AudibleSurface& surface);

/// Of bodies that are ready to move.
[[nodiscard]] AudibleSurface audible_surface(const Preparation& ready);

}  // namespace idiophone::source
