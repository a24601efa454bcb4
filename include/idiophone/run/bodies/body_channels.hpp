#pragma once
// The motion channels of each body and of each piece that it can fall apart into, and all energies, at the motion rate.

#include <mpi.h>

#include <cstdint>
#include <vector>

#include "idiophone/run/bodies/motion_rate_channels.hpp"
#include "idiophone/run/bodies/observation.hpp"

namespace idiophone::bodies {

class BodyChannels : public MotionRateChannels {
 public:
  /// @param ready, motion  must outlive this object
  BodyChannels(const Preparation& ready, motion::Motion& motion, MPI_Comm communicator);

  [[nodiscard]] std::vector<std::vector<double>> collect() override;
  /// Orientations in the last row collected, which decide the sign of the next ones.
  void archive(parallel::Archive& archive) override;

 private:
  void note_row() override;
  const Preparation& ready_;
  motion::Motion& motion_;
  MPI_Comm communicator_;
  std::vector<std::int64_t> words_;               ///< [words per observation x rows]
  std::vector<Eigen::Quaterniond> orientations_;  ///< [bodies, then pieces] in the last row collected; on rank 0
};

}  // namespace idiophone::bodies
