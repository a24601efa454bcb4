#pragma once
// When a run writes checkpoints, and where.

#include <mpi.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/run/results/checkpoint.hpp"
#include "idiophone/scene/settings.hpp"

namespace idiophone::loop {

/// Puts state into an archive.
using ArchiveState = std::function<void(parallel::Archive&)>;

class CheckpointSchedule {
 public:
  /// Its clock begins to run.
  CheckpointSchedule(std::filesystem::path directory, results::Identity identity, const scene::Output& output,
                     MPI_Comm communicator);

  /// Whether a checkpoint is due by this rank's clock.
  [[nodiscard]] bool due() const;

  /// Writes a checkpoint. Collective.
  /// @throws std::runtime_error when it can't be written
  void write(const results::Moment& moment, const ArchiveState& archive_state);

  /// The newest valid checkpoint to resume from, if there is any; reports those that are refused. Collective.
  /// @param files  that the run continues
  /// @throws std::runtime_error when there are checkpoints, but none is valid
  [[nodiscard]] std::optional<results::CheckpointReader> find(const std::vector<results::ContinuedFile>& files) const;

  /// Checkpoints written so far.
  [[nodiscard]] int written() const { return written_; }

 private:
  std::filesystem::path directory_;
  results::Identity identity_;
  double interval_;  ///< s of wall clock; 0 for none but the one at a stop
  int keep_;
  MPI_Comm communicator_;
  double last_;  ///< wall clock, s
  int written_ = 0;
};

}  // namespace idiophone::loop
