#pragma once
// Motions of bodies without strain that their constraints, supports and joints allow.

#include <mpi.h>

#include <vector>

#include "operators.hpp"

namespace idiophone::eigenmodes {

/// What can resist rigid motion.
enum class Resistance { groups_and_supports, groups };

/// Translations and small rotations of each body that no fixed or driven group, no support and no joint resists: none
/// where the body is held, 1 about a hinge, 6 where it is free, 7 of two free bodies with a hinge between them.
/// [motions][3 x owned nodes], linearly independent, without unit. Collective.
/// @param resistance  of groups alone: supports are left out
[[nodiscard]] std::vector<std::vector<double>> rigid_motions(const mesh::Part& part, const Operators& operators,
                                                             MPI_Comm communicator,
                                                             Resistance resistance = Resistance::groups_and_supports);

/// A rough estimate of the lowest frequency at which a free body of this size and thickness vibrates, Hz: sqrt(E/rho)
/// of the material, the mean of several ones, times its thickness 2 V/A over the square of its longest side. Within a
/// factor of three for bars, plates and balls; of a shell, the lowest modes bend it likewise. Collective.
[[nodiscard]] double rough_frequency(const scene::Solids& solids, const mesh::Part& part,
                                     const motion::Dynamics& dynamics, MPI_Comm communicator);

}  // namespace idiophone::eigenmodes
