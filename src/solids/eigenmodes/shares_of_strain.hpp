#pragma once
// How materials and joints share the strain of a mode.

#include <mpi.h>

#include <span>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/dynamics.hpp"

namespace idiophone::eigenmodes {

/// A material region of a body.
struct StrainedRegion {
  const solid::Solid* solid;  ///< the body's
  std::size_t region;
  double share;     ///< x^T K_r x, with the elasticity of the deck
  double relaxing;  ///< of this, what the relaxation acts on: all, but for a loss factor by direction
};

/// x^T K_r x of the stiffness K_r of each region; they add up to `whole`, unless a body is prestressed: then the
/// geometric stiffness has a part of it. Collective.
/// @param shape  x, [3 x owned nodes]
/// @param whole  x^T K x, geometric stiffness included and joints left out
/// @return by bodies, then by regions
[[nodiscard]] std::vector<StrainedRegion> shares_of_strain(const motion::FiniteElementDynamics& dynamics,
                                                           const mesh::Part& part, std::span<const double> shape,
                                                           double whole, MPI_Comm communicator);

/// x^T K_j x of the stiffness K_j of each joint. Collective.
/// @param shape  x, [3 x owned nodes]
/// @return [joints]
[[nodiscard]] std::vector<double> shares_of_joints(const joints::Joints& joints, const mesh::Part& part,
                                                   std::span<const double> shape, MPI_Comm communicator);

}  // namespace idiophone::eigenmodes
