#pragma once
// The surfaces of stored meshes, for drawing.

#include <array>
#include <cstdint>
#include <vector>

#include "idiophone/run/results/frame_reader.hpp"

namespace idiophone::report {

using Triangle = std::array<std::int32_t, 3>;

/// Triangles of the faces that belong to one cell only, counter-clockwise as seen from outside. Nodes of the body.
/// @throws std::runtime_error for cells of unknown form
[[nodiscard]] std::vector<Triangle> surface_of(const results::FramedBody& body);

}  // namespace idiophone::report
