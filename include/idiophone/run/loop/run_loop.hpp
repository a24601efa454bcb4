#pragma once
// A run, as the paper tells it: solids move (3.1), their surfaces move the air (3.2), and listeners hear it (3.3). The
// same loop for every source.

#include <mpi.h>

#include <cstdint>
#include <optional>

#include "idiophone/air/propagation/audio_path.hpp"
#include "idiophone/foundation/parallel/stages.hpp"
#include "idiophone/run/bodies/source.hpp"
#include "idiophone/run/loop/checkpoint_schedule.hpp"
#include "idiophone/run/loop/progress.hpp"
#include "idiophone/run/record/recorder.hpp"
#include "idiophone/run/results/result_file.hpp"

namespace idiophone::loop {

class RunLoop {
 public:
  /// What works together in a run; all of it must outlive the loop.
  struct Participants {
    bodies::Source& source;
    propagation::AudioPath& audio_path;
    record::Recorders& recorders;
    results::ResultFile& result;
    parallel::Stages& stages;
  };

  /// How far a run goes.
  struct Extent {
    std::int64_t sound_samples = 0;  ///< audio samples of sound in the result, at the most
    std::int64_t samples = 0;        ///< audio samples that the source advances
    int steps_per_sample = 1;        ///< steps of the motion in an audio sample
    std::int64_t nodes = 0;          ///< that move in each step, over all ranks
  };

  RunLoop(const Participants& participants, const Extent& extent, MPI_Comm communicator);

  /// Begins with the steady motion, and with new tables in the result. Collective.
  void start();

  /// All that decides the future; restoring takes the place of start(). Collective.
  void archive(parallel::Archive& archive);

  /// Goes on to the end, or until a signal or the clock stops it. Collective.
  /// @param wall_clock_limit  s from now on; none: no limit
  /// @param checkpoints       written when they are due and at a stop; null: none are written
  /// @return whether it went to the end
  /// @throws std::runtime_error when the source or the audio path complains, or files can't be written
  [[nodiscard]] bool run(const std::optional<double>& wall_clock_limit, CheckpointSchedule* checkpoints,
                         Progress& progress);

  /// Audio samples that the source has advanced.
  [[nodiscard]] std::int64_t advanced() const { return advanced_; }

 private:
  /// What rank 0 decides at the end of a block.
  struct Decision {
    std::int64_t next_block = 0;  ///< audio samples in it
    int stop = 0;                 ///< 1: stop although audio samples are missing
    int checkpoint = 0;           ///< 1: write one
  };

  /// Inside a block no rank waits for all others.
  void advance_block(std::int64_t samples);
  void advance_sample();
  void finish_block();
  /// Rank 0's decision on every rank, which any rank's signal turns into a stop. Collective.
  [[nodiscard]] Decision agree(Decision decision) const;
  void write_checkpoint(CheckpointSchedule& checkpoints);

  Participants participants_;
  Extent extent_;
  MPI_Comm communicator_;
  std::int64_t longest_block_;
  surface::SurfaceMotion motion_;
  std::int64_t advanced_ = 0;
};

}  // namespace idiophone::loop
