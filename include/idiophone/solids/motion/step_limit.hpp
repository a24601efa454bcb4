#pragma once
// What limits the step of one body.

#include <mpi.h>
#include <petscsf.h>

#include <cmath>
#include <limits>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::motion {

/// What sets a body's step: its elements, or the stiffness and damping that contacts or their bristles add to them,
/// which at least halve it.
enum class StepCause { elements, contact, bristles };

/// What limits one body's step; as it stands here, nothing: all of the body is held.
struct StableStep {
  double largest_frequency = 0.0;  ///< largest angular eigenfrequency of the undeformed, constrained body's mesh, rad/s
  double damping = 0.0;            ///< 2 zeta w there, 1/s
  double step = std::numeric_limits<double>::infinity();  ///< largest stable dt = (2/w)(sqrt(1 + zeta^2) - zeta), s
  double highest_loss = 0.0;  ///< up to which the body's loss factor is to hold, Hz; 0 where it has none
  StepCause cause = StepCause::elements;
  Index element = 0;                 ///< the element that holds most energy of that eigenmode, global number
  Vector3 centre = Vector3::Zero();  ///< its centre, m

  [[nodiscard]] bool is_limited() const { return std::isfinite(step); }
};

/// The ranks that a body lies on.
struct BodyRanks {
  MPI_Comm communicator = MPI_COMM_SELF;
  PetscSF ghosts = nullptr;  ///< see ghost_exchange; none where all of the body is on this rank
};

/// Springs and dashpots that act on nodes from outside, the same in all directions. [local nodes]
struct Supports {
  std::vector<double> stiffness;  ///< N/m
  std::vector<double> damping;    ///< N s/m
};

/// The largest stable step of an oscillator, (2/w)(sqrt(1 + zeta^2) - zeta), without its cancellation for large zeta,
/// s.
/// @param w        rad/s
/// @param damping  2 zeta w, 1/s
[[nodiscard]] double largest_step(double w, double damping);

}  // namespace idiophone::motion
