#pragma once
// From the motion of surfaces to sound in a result: emission, air, listeners (paper, sections 3.2 and 3.3). The same
// for every source.

#include <mpi.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "idiophone/hearing/air.hpp"
#include "idiophone/parallel/stages.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/source/audible_surface.hpp"
#include "idiophone/store/result_file.hpp"
#include "idiophone/surface/emitter.hpp"

namespace idiophone::hearing {

class AudioPath {
 public:
  /// Collective.
  /// @param scene      whose listeners hear; must outlive this object, as must `stages`
  /// @param steady     audio sample of the steady motion that comes first
  /// @throws std::runtime_error when Embree fails
  AudioPath(const scene::Scene& scene, const source::AudibleSurface& surface, std::int64_t steady,
            parallel::Stages& stages, MPI_Comm communicator);

  /// Adds a series for each listener, and the frequencies the sound is expected to have, to a new result. Collective.
  void declare(store::ResultFile& result) const;

  /// The audio sample whose emission makes so many audio samples of sound final.
  [[nodiscard]] std::int64_t completing_sample(std::int64_t samples) const { return samples - air_->final_before(0); }

  /// The force of the air on the bodies, which they have to be coupled to before anything begins; null where the deck
  /// does not ask for it.
  [[nodiscard]] source::AirLoad* load() { return air_->load(); }

  /// Begins after a motion that is taken to have lasted for ever. Collective.
  void start(const surface::SurfaceMotion& steady);

  /// Takes the motion of the next audio sample to all listeners. No collective call that waits: a problem is kept
  /// until check().
  void hear(const surface::SurfaceMotion& motion);

  /// At the end of a block. Collective.
  /// @throws std::runtime_error, on all ranks, when a sound was not finite or too loud
  void check() const;

  /// Writes the audio samples that are final. Collective.
  /// @param most  audio samples in the result at the most
  void write(store::ResultFile& result, std::int64_t most);

  /// Largest magnitude of any audio sample written so far, on rank 0.
  [[nodiscard]] double loudest() const { return loudest_; }

  /// All that decides the future. Restoring takes the place of start(). Collective.
  void archive(parallel::Archive& archive);

 private:
  const scene::Scene& scene_;
  parallel::Stages& stages_;
  MPI_Comm communicator_;
  parallel::Rows triangle_rows_;
  surface::Emitter emitter_;
  surface::Emission emission_;
  std::unique_ptr<Air> air_;
  std::int64_t emitted_;      ///< the audio sample that was heard last
  std::int64_t written_ = 0;  ///< audio samples in the result
  double loudest_ = 0.0;
  std::string problem_;
};

}  // namespace idiophone::hearing
