#pragma once
// Solids with walls and edges along the axes.

#include <array>
#include <functional>
#include <vector>

#include "vibrating_solid.hpp"

namespace idiophone::waves {

/// Planes across each axis, ascending, m.
using Grating = std::array<std::vector<double>, 3>;

/// The surface of those blocks between planes whose middles are in a solid.
[[nodiscard]] radiation::Solid of_blocks(const Grating& planes, const std::function<bool(const Vector3&)>& is_solid);

}  // namespace idiophone::waves
