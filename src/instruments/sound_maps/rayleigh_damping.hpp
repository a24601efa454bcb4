#pragma once
// Rayleigh damping of a body, from the decay of its modes.

#include <optional>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

/// A mode of angular frequency w decays by (alpha + beta w^2) / 2 in a second.
struct RayleighDamping {
  double alpha = 0.0;  ///< proportional to mass, 1/s
  double beta = 0.0;   ///< proportional to stiffness, s
};

/// The two coefficients that give the decay of all modes by the material within 1 %, by least squares of relative
/// errors; nothing where none do, as for a loss factor, and for fewer than two modes.
[[nodiscard]] std::optional<RayleighDamping> rayleigh_damping(const SoundMap& map);

}  // namespace idiophone::sound_maps
