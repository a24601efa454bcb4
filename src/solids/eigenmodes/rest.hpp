#pragma once
// Where bodies rest under their prestress: their modes are about there.

#include <mpi.h>

#include <span>
#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/motion/assembly.hpp"
#include "idiophone/solids/motion/dynamics.hpp"

namespace idiophone::eigenmodes {

/// Displacements of the nodes in static equilibrium of bodies and joints under a prestress that deforms a body, with
/// large displacements.
/// By Newton's method on all ranks, with the elastic moduli at rest. Gravity is left out. Collective.
/// @param deformed    [bodies] 1: its prestress deforms it, as motion::deformed_by_prestress() says; one is
/// @param support     stiffness of the supports, N/m, [owned nodes]
/// @param components  that are free
/// @return [local nodes]
/// @throws deck::DeckError, pointing at the prestress of the first body that is deformed, where nothing holds the
///         bodies or no equilibrium is found
[[nodiscard]] std::vector<solid::NodeState> rest_under_prestress(const scene::Solids& solids, const mesh::Part& part,
                                                                 const motion::FiniteElementDynamics& dynamics,
                                                                 std::span<const char> deformed,
                                                                 std::span<const double> support,
                                                                 const motion::Components& components,
                                                                 MPI_Comm communicator);

}  // namespace idiophone::eigenmodes
