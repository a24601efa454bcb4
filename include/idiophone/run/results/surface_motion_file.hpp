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

#include "idiophone/air/surface/recording.hpp"
#include "idiophone/foundation/parallel/archive.hpp"

namespace idiophone::results {

class SurfaceMotionFile {
 public:
  /// Prefix of the names in archive().
  static constexpr const char* archive_prefix = "record/surface";

  /// Creates the file; overwrites an existing one.
  /// @param surface  its rows must outlive this object
  /// @throws std::runtime_error if it can't be created (with the system's reason).
  [[nodiscard]] static SurfaceMotionFile create(const std::filesystem::path& path,
                                                const surface::RecordingHeader& header,
                                                const surface::RecordedSurface& surface, MPI_Comm communicator);

  /// Opens the recording of a run that is to be resumed.
  /// @throws std::runtime_error if it is not there, damaged, no recording, or of another surface.
  [[nodiscard]] static SurfaceMotionFile open(const std::filesystem::path& path,
                                              const surface::RecordedSurface& surface, MPI_Comm communicator);

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
