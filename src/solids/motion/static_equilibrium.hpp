#pragma once
// Where a body rests under its plucks: the start of a released pluck, by PETSc's SNES.

#include <vector>

#include "idiophone/solids/motion/dynamics.hpp"

namespace idiophone::motion {

/// Displacements of all nodes in the initial state: bodies with plucks in static equilibrium under these, gravity,
/// their supports and constraints, with large displacements; other bodies undisplaced. Runs on one rank, so that its
/// numbers do not depend on how many there are. The load grows in more and more increments until Newton's method
/// converges.
/// @param dynamics  of the whole mesh, on this rank alone
/// @param part      the whole mesh as one part
/// @return [3 x global nodes], m; empty where nothing is plucked
/// @throws deck::DeckError, pointing at the pluck, where the body is not held or no equilibrium is found
[[nodiscard]] std::vector<double> static_equilibrium(const scene::Solids& solids, const mesh::Part& part,
                                                     const Attachments& attachments,
                                                     const FiniteElementDynamics& dynamics);

}  // namespace idiophone::motion
