#pragma once
// A job, as the paper tells it: a source moves surfaces (3.1), the air takes their sound (3.2) to listeners (3.3), and
// a result keeps it. The commands choose the parts.

#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "idiophone/foundation/accelerator/accelerator.hpp"
#include "idiophone/run/loop/run_loop.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::loop {

/// What a source computes in each step of its motion.
struct StepSize {
  int steps_per_sample = 1;  ///< steps of the motion in an audio sample
  std::int64_t nodes = 0;    ///< that move, over all ranks
  double elements = 0.0;     ///< over all ranks
};

/// Checkpoints of a job.
struct JobCheckpoints {
  results::Identity identity;                     ///< what a checkpoint must have in common with the job
  std::vector<results::ContinuedFile> continued;  ///< files that a resumed job goes on with, the result among them
  bool resume = false;                            ///< go on from the newest one
};

/// The parts of a job. What is referred to must outlive the job.
struct Job {
  const scene::Scene& scene;     ///< whose listeners hear; the files have its name
  bodies::Source& source;        ///< what moves
  parallel::Stages& stages;      ///< what the time goes into, the source's included
  std::filesystem::path folder;  ///< for NAME.h5, NAME.wav and NAME_checkpoints
  std::int64_t sound_samples;    ///< audio samples of sound in the result, at the most

  /// Facts for /run of a new result, on rank 0. Collective.
  std::function<nlohmann::json()> facts;

  std::optional<std::int64_t> samples = {};     ///< that the source advances; none: until the sound is complete
  std::optional<StepSize> step = {};            ///< none where the motion is given
  std::optional<double> wall_clock_limit = {};  ///< s, for the loop
  std::optional<JobCheckpoints> checkpoints = {};
  ProgressStyle progress = ProgressStyle::silent;
  accelerator::Accelerator* accelerator = nullptr;  ///< which computes waves on a grid; null: the processor does

  /// Facts for this job in /run, besides those that each job has. Collective. None if empty.
  std::function<nlohmann::json()> job_facts = {};

  /// What writes more than the sound. Collective. None if empty.
  std::function<record::Recorders(results::ResultFile&)> recorders = {};
};

/// How a job ended.
struct JobEnding {
  int status = 0;               ///< exit_finished or exit_resumable
  double processor_time = 0.0;  ///< of this rank in the loop, s
};

/// Does a job: from the beginning or a checkpoint to the end, or until a signal or the clock stops it. The result says
/// what was done and how long it took; at the end, WAV files are written. Collective.
/// @throws std::runtime_error when the source or the air complains, or files can't be read or written
[[nodiscard]] JobEnding perform(const Job& job, MPI_Comm communicator);

}  // namespace idiophone::loop
