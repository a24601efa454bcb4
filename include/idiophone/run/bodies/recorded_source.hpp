#pragma once
// A recorded surface motion. Each rank has a range of its triangles, and a range of vertices that holds their corners.

#include <mpi.h>

#include <cstdint>
#include <string>
#include <vector>

#include "idiophone/run/bodies/source.hpp"
#include "idiophone/run/results/surface_motion_reader.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::bodies {

/// Whether the obstacles of a recording stand in the way of its sound.
enum class RecordedObstacles { keep, leave_out };

/// Checks the recordings of a scene's recorded bodies, and reports those that end before the sound. Call on one rank.
/// @throws deck::DeckError, with the place in the deck, for a recording that can't be read, or has another audio rate
///         or other air than the scene
void check_recordings(const scene::Scene& scene);

/// A fingerprint of the scene's recordings, which distinguishes them from others of the same names; empty if there are
/// none. Call on one rank.
[[nodiscard]] std::string fingerprint(const scene::Scene& scene);

class RecordedSource : public Source {
 public:
  /// Collective.
  /// @param name       of the recording, for the archive and for messages
  /// @param radiation  whether it needs the triangles' equivalent radii
  /// @throws std::runtime_error when the surface can't be read
  RecordedSource(std::string name, results::SurfaceMotionReader reader, const scene::Radiation& radiation,
                 RecordedObstacles obstacles, MPI_Comm communicator);

  [[nodiscard]] std::int64_t first_sample() const override { return reader_.header().first_sample; }
  void start(surface::SurfaceMotion& motion) override;
  /// After the last row, the surface stays still where it is.
  void advance(surface::SurfaceMotion& motion) override;
  /// Throws when rows could not be read.
  void check() override;
  void archive(parallel::Archive& archive) override;

  /// Audio samples that it can advance before it stays still.
  [[nodiscard]] std::int64_t samples() const { return reader_.rows() - 1; }
  [[nodiscard]] const surface::RecordingHeader& header() const { return reader_.header(); }

 private:
  /// The motion of a row. Reads as many rows at once as fit into some 16 MB.
  void take(std::int64_t row, surface::SurfaceMotion& motion);
  void read_rows(std::int64_t row);

  std::string name_;
  results::SurfaceMotionReader reader_;
  std::int64_t first_triangle_ = 0;  ///< this rank's first ones, numbered as in the recording
  std::int64_t first_vertex_ = 0;
  MPI_Comm communicator_;
  std::int64_t sample_ = 0;  ///< audio samples advanced: the row, as long as there are any
  std::int64_t begin_ = 0;   ///< first row in memory
  std::int64_t end_ = 0;     ///< one past the last
  std::vector<double> pressure_;
  std::vector<double> position_;
  std::int64_t stage_ = -1;    ///< of the reader, that the radii were found for, where triangles change
  std::vector<double> radii_;  ///< equivalent ones, m
  std::string problem_;
};

}  // namespace idiophone::bodies
