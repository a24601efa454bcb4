#pragma once
// Sonic scenes in the commands `timbre` and `run`.

#include <mpi.h>

#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/run/bodies/channel.hpp"
#include "idiophone/run/loop/progress.hpp"
#include "idiophone/run/results/result_file.hpp"
#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"
#include "idiophone/timbre/track/soundtrack.hpp"

namespace idiophone::timbre {

/// The sounds of a scene, with progress. On one rank.
/// @throws as timbre::add_sounds() and timbre::Soundtrack::render()
[[nodiscard]] std::vector<timbre::TrackSound> rendered_sounds(const timbre::SonicScene& scene,
                                                              const timbre::MotionChannels& motion,
                                                              loop::ProgressWish progress);

/// Writes the music of a scene, if it has any, as FILE with the extensions .mid and .musicxml. On one rank.
/// @throws as compose(); std::runtime_error if a file can't be written
void write_music(const timbre::SonicScene& scene, const timbre::MotionChannels& motion, std::filesystem::path file);

/// A sonic scene beside the deck of a run: its sounds become part of the result when the motion is complete.
class SceneOfRun {
 public:
  /// Reads the scene on all ranks. Collective.
  /// @throws deck::DeckError on rank 0 for a wrong scene
  SceneOfRun(const std::filesystem::path& scene, MPI_Comm communicator);

  /// The text of the scene and of its trees.
  [[nodiscard]] std::string text() const;

  /// A table for the sound of each listener: /audio/SCENE_LISTENER, or /audio/SCENE if the scene has no listeners.
  [[nodiscard]] std::vector<spectra::Series> tables() const;

  /// Adds the empty tables and the text of the scene to the result of a run that begins. Collective.
  void declare(results::ResultFile& result) const;

  /// Finds out which channels of the run its sounds need. From now on, keeps their rows in memory, on rank 0; those
  /// that a resumed run has already are in its result. This object must stay where it is. Collective.
  /// @throws deck::DeckError on rank 0 if the scene does not agree with the channels
  void bind(bodies::Channels& channels, results::ResultFile& result, const std::filesystem::path& path);

  /// Renders the sounds from the motion, on rank 0, and appends them. Writes the music beside the result. Collective.
  void render(results::ResultFile& result, const std::filesystem::path& path, loop::ProgressWish progress) const;

 private:
  timbre::SonicScene scene_;
  std::vector<spectra::Series> channels_;  ///< of the run
  MotionRows rows_;                        ///< of the channels that the scene names, on rank 0
  MPI_Comm communicator_;
};

}  // namespace idiophone::timbre
