#pragma once
// A run, as the paper tells it: the solids move (3.1), their surfaces move the air (3.2), and listeners hear it (3.3).

#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "idiophone/hearing/audio_path.hpp"
#include "idiophone/parallel/stages.hpp"
#include "idiophone/record/observer.hpp"
#include "idiophone/record/surface_recorder.hpp"
#include "idiophone/source/preparation.hpp"
#include "idiophone/store/checkpoint.hpp"
#include "idiophone/store/result_file.hpp"
#include "idiophone/surface/surface.hpp"
#include "progress.hpp"

namespace idiophone::app {

class Simulation {
 public:
  /// @param directory  where the results go; made if it isn't there
  /// @param resume     go on from the newest valid checkpoint there
  /// @throws std::runtime_error where files can't be written, or a checkpoint can't be resumed from
  Simulation(const source::Preparation& ready, const std::filesystem::path& directory, bool resume,
             MPI_Comm communicator);

  /// Runs to the end or until it is asked to stop.
  /// @param progress_line  whether progress is one updating line
  /// @return the exit status: exit_finished or exit_resumable
  /// @throws std::runtime_error when the motion becomes unstable, or files can't be written
  int run(bool progress_line);

 private:
  /// What rank 0 decides at the end of a block.
  struct Verdict {
    std::int64_t next_block = 0;  ///< audio samples in it
    int stop = 0;
    int checkpoint = 0;
  };

  void begin();
  void resume_from(const store::CheckpointReader& checkpoint);
  void advance_sample();
  void read_surface();
  [[nodiscard]] std::vector<double> surface_velocities() const;
  void finish_block();
  void require_stability();
  [[nodiscard]] double deepest(std::size_t contact);
  [[nodiscard]] Verdict agree(double block_seconds, std::int64_t block);
  void write_checkpoint();
  void report_overlaps();
  void report_silence() const;
  void report_penetrations();

  const source::Preparation& ready_;
  MPI_Comm communicator_;
  int rank_ = 0;
  int ranks_ = 1;
  std::filesystem::path result_path_;
  std::filesystem::path checkpoint_directory_;
  store::Identity identity_;
  parallel::Stages stages_;
  motion::Motion motion_;
  surface::Surface surface_;
  surface::SurfaceMotion surface_motion_;
  hearing::AudioPath audio_path_;
  record::Observer observer_;
  parallel::Rows node_rows_;      ///< of the checkpoint: owned nodes, globally numbered
  parallel::Rows triangle_rows_;  ///< likewise
  parallel::Rows vertex_rows_;    ///< likewise
  std::optional<store::ResultFile> result_;
  std::optional<record::SurfaceRecorder> recorder_;  ///< if the deck asks for it

  std::int64_t sample_ = 0;         ///< audio samples that the motion has done
  std::int64_t sound_samples_ = 0;  ///< that the deck asks for
  std::int64_t last_sample_ = 0;    ///< audio samples that the motion has to do
  double energy_at_start_ = 0.0;    ///< gravitational energy included, J
  double largest_given_ = 0.0;      ///< by start, loads and gravity, to move and deform, at the end of any block, J
  double started_ = 0.0;            ///< wall clock, s
  double last_checkpoint_ = 0.0;    ///< wall clock, s
  int checkpoints_ = 0;             ///< written by this job
};

}  // namespace idiophone::app
