#pragma once
// Where a body rests under its plucks and its prestress: the start of a run, by PETSc's SNES.

#include <vector>

#include "idiophone/solids/motion/dynamics.hpp"

namespace idiophone::motion {

/// Displacements of all nodes in the initial state: bodies with plucks, and those that their prestress deforms, in
/// static equilibrium under both, gravity, their supports and constraints, with large displacements; other bodies
/// undisplaced. A modal body that no joint holds is displaced by its plucks alone, from where its prestress leaves it.
/// Runs on one rank, so that its numbers do not depend on how many there are. The load grows in more and more
/// increments until Newton's method converges.
/// @param dynamics  of the whole mesh, on this rank alone
/// @param part      the whole mesh as one part
/// @return [3 x global nodes], m; empty where nothing is displaced
/// @throws deck::DeckError, pointing at the pluck or the prestress, where the body is not held or no equilibrium is
/// found
[[nodiscard]] std::vector<double> static_equilibrium(const scene::Solids& solids, const mesh::Part& part,
                                                     const Attachments& attachments,
                                                     const FiniteElementDynamics& dynamics);

}  // namespace idiophone::motion
