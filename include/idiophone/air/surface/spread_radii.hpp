#pragma once
// Equivalent radii of triangles that are some of several bodies'.

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::surface {

/// All triangles of a body, three corners each, m.
using SurfaceOfBody = std::function<std::vector<std::array<Vector3, 3>>(std::size_t body)>;

/// surface::equivalent_radii of each triangle, m. A body's last triangles may be inside it until it breaks. The others'
/// radii are those of a body without them; theirs are those among all triangles.
/// @param triangle_ids    global numbers, ascending
/// @param first_triangle  of each body, and one past the last: [bodies + 1]
/// @param surface_of      asked once for each body, in order, also for those that none of the triangles is of
/// @param inside          [bodies] number of triangles inside each; empty: none
[[nodiscard]] std::vector<double> spread_radii(std::span<const Index> triangle_ids,
                                               std::span<const Index> first_triangle, const SurfaceOfBody& surface_of,
                                               std::span<const std::size_t> inside = {});

}  // namespace idiophone::surface
