#pragma once
// How masses are moved in time, and how long a step may be.

#include "idiophone/instruments/proxies/lattice.hpp"

namespace idiophone::proxies {

enum class Integrator {
  symplectic_euler,  ///< velocities first, then displacements by the new velocities; keeps the energy of free
                     ///< vibrations
  improved_euler     ///< Heun's method: O'Morain's choice; it adds energy to what is not damped enough
};

/// The smallest number of equal steps in an interval with which no oscillator up to an angular frequency grows.
/// @param interval  s
/// @throws std::invalid_argument when it would be more than 100 000: improved_euler is never stable without damping
[[nodiscard]] int stable_steps(Integrator integrator, double angular_frequency, const Damping& damping,
                               double interval);

}  // namespace idiophone::proxies
