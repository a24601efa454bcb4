#pragma once
// The surface of an obstacle as triangles, for whoever looks at it rather than touches it.

#include <array>
#include <vector>

#include "idiophone/solids/contact/rigid_shape.hpp"

namespace idiophone::contact {

/// The exterior faces of a shape's parts, cut into triangles whose corners run around the outward normal, m. A
/// half-space has no bounds and gives none.
[[nodiscard]] std::vector<std::array<Vector3, 3>> outline(const RigidShape& shape);

}  // namespace idiophone::contact
