#pragma once
// Writes the motion of all surfaces, so that it can be listened to later.

#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/run/record/recorder.hpp"
#include "idiophone/run/results/surface_motion_file.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::record {

/// NAME_surface.h5 beside NAME.h5.
[[nodiscard]] std::filesystem::path recording_of(const std::filesystem::path& result);

/// What one audio sample of a recording takes, bytes.
[[nodiscard]] double recorded_bytes_per_sample(const bodies::Preparation& ready);

class SurfaceRecorder : public Recorder {
 public:
  /// Collective.
  /// @param surface  must outlive this object
  /// @param steady   audio sample of the steady motion that comes first
  /// @param samples  of sound that the motion is computed for
  SurfaceRecorder(const scene::Scene& scene, const propagation::AudibleSurface& surface, std::int64_t steady,
                  std::int64_t samples, std::filesystem::path path, MPI_Comm communicator);

  void declare() override;
  void note(std::int64_t sample, const surface::SurfaceMotion& motion) override;
  void write() override;
  /// Restoring cuts the file back to the rows it had.
  void archive(parallel::Archive& archive) override;
  /// As many as fit into 64 MB of each rank.
  [[nodiscard]] std::int64_t longest_block() const override { return longest_block_; }

 private:
  [[nodiscard]] surface::RecordedSurface recorded() const;

  const propagation::AudibleSurface& surface_;
  MPI_Comm communicator_;
  parallel::Rows triangles_;
  parallel::Rows vertices_;
  std::filesystem::path path_;
  surface::RecordingHeader header_;
  std::vector<std::int32_t> corners_;  ///< [3 x triangles here] global vertex numbers
  std::vector<double> reference_;      ///< [3 x vertices here], m
  std::int64_t longest_block_ = 1;
  std::optional<results::SurfaceMotionFile> file_;
  std::int64_t noted_ = 0;        ///< rows
  std::vector<double> pressure_;  ///< [triangles here x noted], Pa
  std::vector<double> position_;  ///< [3 x vertices here x noted], m
};

}  // namespace idiophone::record
