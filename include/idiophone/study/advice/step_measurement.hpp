#pragma once
// How long a step takes, measured on a motion of all bodies.

#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/study/advice/memory_estimate.hpp"

namespace idiophone::advice {

/// Processor time of a step of all bodies, of all ranks together.
struct StepSeconds {
  double force = 0.0;  ///< of the elements, s
  double whole = 0.0;  ///< s
};

struct StepMeasurement {
  StepSeconds step;
  MemoryEstimate memory;
};

/// Steps for a fraction of a second. Collective.
/// @param program  memory before the meshes were read, bytes
[[nodiscard]] StepMeasurement measure_steps(const bodies::Preparation& ready, double program, MPI_Comm communicator);

}  // namespace idiophone::advice
