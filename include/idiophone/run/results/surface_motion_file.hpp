#pragma once
// NAME_surface.h5: the motion of all surfaces at the audio rate, for `idiophone listen` and recorded bodies.
// docs/use/surface_motion.md describes each dataset.
//
// Every call is collective over the communicator the file was made with; an error on one rank is thrown on all.
// What was appended is on the disk after flush(), which closes the file until the next call.

#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/foundation/parallel/rows.hpp"
#include "idiophone/run/results/result_file.hpp"

namespace idiophone::results {

/// The first triangle and vertex of one body; the last ones are before those of the next body.
struct BodyOffsets {
  std::string name;
  std::int32_t first_triangle = 0;
  std::int32_t first_vertex = 0;
};

/// All of a recording but the motion. The same on all ranks.
struct RecordingHeader {
  files::Origin origin;
  double rate = 0.0;                       ///< rows per second: audio samples
  std::int64_t first_sample = 0;           ///< audio sample of row 0, at most 0: the motion before was steady
  std::int64_t samples = 0;                ///< of sound after the recorded motion
  double air_density = 0.0;                ///< used for the pressures, kg/m3
  double air_speed = 0.0;                  ///< speed of sound, likewise, m/s
  std::vector<BodyOffsets> bodies;         ///< in ascending order
  std::vector<double> obstacle_triangles;  ///< [9 x triangles] corners of obstacles, m
  std::vector<double> half_spaces;         ///< [6 x half-spaces] a point of the plane, m, and its outward normal
};

/// The partitioned surface. Triangles and vertices are numbered over all bodies.
struct RecordedSurface {
  const parallel::Rows* triangles = nullptr;  ///< those of this rank
  const parallel::Rows* vertices = nullptr;   ///< likewise
  std::span<const std::int32_t> corners;      ///< [3 x local triangles] global vertex numbers
  std::span<const double> reference;          ///< [3 x local vertices] undeformed positions, m
};

class SurfaceMotionFile {
 public:
  /// Prefix of the names in archive().
  static constexpr const char* archive_prefix = "record/surface";

  /// Creates the file; overwrites an existing one.
  /// @param surface  its rows must outlive this object
  /// @throws std::runtime_error if it can't be created (with the system's reason).
  [[nodiscard]] static SurfaceMotionFile create(const std::filesystem::path& path, const RecordingHeader& header,
                                                const RecordedSurface& surface, MPI_Comm communicator);

  /// Opens the recording of a run that is to be resumed.
  /// @throws std::runtime_error if it is not there, damaged, no recording, or of another surface.
  [[nodiscard]] static SurfaceMotionFile open(const std::filesystem::path& path, const RecordedSurface& surface,
                                              MPI_Comm communicator);

  SurfaceMotionFile(SurfaceMotionFile&&) noexcept;
  SurfaceMotionFile& operator=(SurfaceMotionFile&&) noexcept;
  SurfaceMotionFile(const SurfaceMotionFile&) = delete;
  SurfaceMotionFile& operator=(const SurfaceMotionFile&) = delete;
  ~SurfaceMotionFile();

  /// Appends the motion of one or more audio samples.
  /// @param rows      audio samples, the same on all ranks
  /// @param pressure  [local triangles x rows], a row's triangles side by side, Pa
  /// @param position  [3 x local vertices x rows], likewise, m
  void append(std::int64_t rows, std::span<const double> pressure, std::span<const double> position);

  /// Writes everything to the disk and closes the file.
  void flush();

  /// Length and checksum of every table. Restoring truncates the tables to their lengths at the checkpoint.
  /// @throws std::runtime_error, and truncates nothing, if a table is shorter than at the checkpoint
  void archive(parallel::Archive& archive);

 private:
  struct State;
  explicit SurfaceMotionFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace idiophone::results
