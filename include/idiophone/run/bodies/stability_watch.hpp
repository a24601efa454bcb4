#pragma once
// Whether a computed motion is stable: whether bodies have more energy than they were given.

#include <mpi.h>

#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/run/bodies/observation.hpp"

namespace idiophone::bodies {

class StabilityWatch {
 public:
  /// @param ready  must outlive this object
  explicit StabilityWatch(const Preparation& ready) : ready_(ready) {}

  /// Begins with the energy of the initial state.
  /// @param seen  on rank 0
  void start(const Observation& seen);

  /// Compares the energy that is found with the energy that initial state, loads and gravity gave. Collective.
  /// @param seen  on rank 0
  /// @param time  s, for the message
  /// @throws std::runtime_error, on all ranks, when it is more than ten times as much, or not finite
  void check(const Observation& seen, double time, MPI_Comm communicator);

  void archive(parallel::Archive& archive);

 private:
  const Preparation& ready_;
  double energy_at_start_ = 0.0;  ///< gravitational energy included, J; on rank 0
  double largest_given_ = 0.0;    ///< to move and deform, at the end of any block, J; on rank 0
};

}  // namespace idiophone::bodies
