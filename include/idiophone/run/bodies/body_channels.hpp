#pragma once
// The motion channels of each body, and all energies, at the motion rate.

#include <mpi.h>

#include <cstdint>
#include <vector>

#include "idiophone/run/bodies/channel.hpp"
#include "idiophone/run/bodies/observation.hpp"

namespace idiophone::bodies {

/// Audio samples between two rows of the channels at the motion rate; 0 for none.
[[nodiscard]] std::int64_t samples_per_motion_row(const scene::Scene& scene);

class BodyChannels : public ChannelGroup {
 public:
  /// @param ready, motion  must outlive this object
  BodyChannels(const Preparation& ready, motion::Motion& motion, MPI_Comm communicator);

  void note(std::int64_t sample) override;
  [[nodiscard]] std::vector<std::vector<double>> collect() override;
  /// Orientations in the last row collected, which decide the sign of the next ones.
  void archive(parallel::Archive& archive) override;

 private:
  const Preparation& ready_;
  motion::Motion& motion_;
  MPI_Comm communicator_;
  std::int64_t stride_;                           ///< audio samples between rows; 0 for none
  std::vector<std::int64_t> words_;               ///< [words per observation x rows]
  std::vector<Eigen::Quaterniond> orientations_;  ///< [bodies] in the last row collected; on rank 0
};

}  // namespace idiophone::bodies
