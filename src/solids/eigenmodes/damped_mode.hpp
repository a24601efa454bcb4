#pragma once
// From an eigenpair to a mode with its damping.

#include <mpi.h>

#include "eigensolver.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "operators.hpp"

namespace idiophone::eigenmodes {

/// Frequency and damping of an eigenpair as materials, supports and joints damp it, and its shape, turned so that its
/// largest component is positive. Collective.
/// @param of_stress  what a stress at rest that the operators do not have adds to the eigenvalue, 1/s2: it has no
/// losses
[[nodiscard]] Mode damped_mode(Eigenpair pair, const scene::Solids& solids, const Operators& operators,
                               const mesh::Part& part, MPI_Comm communicator, double of_stress = 0.0);

}  // namespace idiophone::eigenmodes
