#pragma once
// Which bodies stretch where they vibrate by large amplitudes, and how accurately.

#include <span>

#include "idiophone/scene/body.hpp"

namespace idiophone::scene {

[[nodiscard]] bool has_large_amplitudes(const Body& body);

/// Of bodies with common modes: the smallest of their tolerances.
/// @param bodies  at least one; all have large amplitudes
/// @return share of the energy of stretching that may be left out
[[nodiscard]] double stretching_tolerance(std::span<const Body> bodies);

}  // namespace idiophone::scene
