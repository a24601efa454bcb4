#pragma once
// How the materials of a body share the strain of a mode.

#include <mpi.h>

#include <span>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/solid.hpp"

namespace idiophone::eigenmodes {

/// x^T K_r x of each region's stiffness K_r, with the elasticity of the deck; they add up to `whole`, unless
/// the body is prestressed: then the geometric stiffness has a part of it. Collective.
/// @param part   of one body
/// @param shape  x, [3 x owned nodes]
/// @param whole  x^T K x, geometric stiffness included
/// @return [regions]
[[nodiscard]] std::vector<double> shares_of_strain(const solid::Solid& solid, const mesh::Part& part,
                                                   std::span<const double> shape, double whole, MPI_Comm communicator);

}  // namespace idiophone::eigenmodes
