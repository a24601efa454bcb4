#pragma once
// Writes the motion of all surfaces down, so that others may listen to it later. Keeps what it noted until the end of
// the block, so that nobody waits for another rank inside one.

#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "idiophone/source/preparation.hpp"
#include "idiophone/store/surface_motion_file.hpp"
#include "idiophone/surface/surface_motion.hpp"

namespace idiophone::record {

/// NAME_surface.h5 beside NAME.h5.
[[nodiscard]] std::filesystem::path recording_of(const std::filesystem::path& result);

/// What one audio sample of a recording takes, bytes.
[[nodiscard]] double recorded_bytes_per_sample(const source::Preparation& ready);

class SurfaceRecorder {
 public:
  /// @param steady   audio sample of the steady motion that comes first
  /// @param samples  of sound that the motion is computed for
  SurfaceRecorder(const source::Preparation& ready, const parallel::Rows& triangles, const parallel::Rows& vertices,
                  std::int64_t steady, std::int64_t samples, std::filesystem::path path, MPI_Comm communicator);

  /// Begins a new recording. Collective.
  void create();
  /// Goes on with a recording, cut back to so many audio samples and the steady motion before them. Collective.
  void resume(std::int64_t samples);

  /// Notes the steady motion, or that of the next audio sample. No communication.
  void note(const surface::SurfaceMotion& motion);

  /// Audio samples that may be noted before they have to be written: those that fit into 64 MB of each rank.
  /// The same on all ranks.
  [[nodiscard]] std::int64_t most_samples() const { return most_samples_; }

  /// Writes all that was noted since the last writing. Collective.
  void write();

 private:
  [[nodiscard]] store::RecordedSurface surface() const;
  [[nodiscard]] std::vector<store::RecordedBody> bodies() const;

  const source::Preparation& ready_;
  const parallel::Rows& triangles_;
  const parallel::Rows& vertices_;
  MPI_Comm communicator_;
  std::filesystem::path path_;
  store::RecordingHeader header_;
  std::vector<std::int32_t> corners_;  ///< [3 x triangles here] global vertex numbers
  std::vector<double> reference_;      ///< [3 x vertices here], m
  std::int64_t most_samples_ = 1;
  std::optional<store::SurfaceMotionFile> file_;
  std::int64_t noted_ = 0;        ///< audio samples
  std::vector<double> pressure_;  ///< [triangles here x noted], Pa
  std::vector<double> position_;  ///< [3 x vertices here x noted], m
};

}  // namespace idiophone::record
