#pragma once
// What listeners hear of a solution at the surface.

#include <span>
#include <vector>

#include "idiophone/air/harmonic/body_radiation.hpp"
#include "idiophone/air/harmonic/boundary_elements.hpp"
#include "idiophone/scene/listeners.hpp"
#include "idiophone/scene/radiation_section.hpp"

namespace idiophone::harmonic {

/// Gives a result the names and the places of its listeners (scene::still_receivers()), without what they hear.
void place_listeners(Radiation& radiation, std::span<const scene::Listener> listeners);

/// Pressure at each place, Pa, with the absorption of the air on the way.
/// @param elements   that the sound was solved on
/// @param sound      with its frequency and solution
/// @param positions  m
/// @param air        its density and speed have no effect: they are in the solution
[[nodiscard]] std::vector<Complex> pressures_at_listeners(const BoundaryElements& elements, const RadiatedSound& sound,
                                                          std::span<const Vector3> positions,
                                                          const scene::AirProperties& air);

/// Gives a result other listeners: they hear its solutions, and nothing is solved again.
/// @param radiation  with its solutions
/// @param air        as of pressures_at_listeners()
/// @throws std::invalid_argument as BoundaryElements
void replace_listeners(Radiation& radiation, std::span<const scene::Listener> listeners,
                       const scene::AirProperties& air);

}  // namespace idiophone::harmonic
