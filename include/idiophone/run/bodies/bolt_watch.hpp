#pragma once
// Whether a motion takes more off bolts than their preload: then parts that they clamp would come apart, or their heads
// come off (docs/use/joints.md#bolts).

#include <mpi.h>

#include <cstdint>
#include <vector>

#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/solids/joints/bolt_forces.hpp"
#include "idiophone/solids/motion/motion.hpp"

namespace idiophone::bodies {

class BoltWatch {
 public:
  /// Collective.
  /// @param ready, motion  must outlive this object
  BoltWatch(const Preparation& ready, const motion::Motion& motion, MPI_Comm communicator);

  /// Looks at the bolts now. No communication.
  /// @param sample  audio sample that the motion has reached: the one after that of the last call, from 0 on
  void note(std::int64_t sample);

  /// Warns of each bolt that lost its preload for the first time since the last call. Collective.
  void check();

  /// How much each bolt lost at most.
  void report() const;

  void archive(parallel::Archive& archive);

 private:
  void take(std::size_t force, double taken, double time);
  [[nodiscard]] bool has_preload_left(std::size_t bolt) const;

  const Preparation& ready_;
  const motion::Motion& motion_;
  MPI_Comm communicator_;
  joints::BoltForces forces_;
  std::int64_t last_sample_ = 0;     ///< that was noted
  std::vector<std::int64_t> words_;  ///< [samples][forces] of reproducible sums, not yet checked
  std::vector<double> most_taken_;   ///< [forces] parts of the preload; on rank 0
};

}  // namespace idiophone::bodies
