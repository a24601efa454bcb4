#pragma once
// From the motion of surfaces to sound in a result: emission, radiation, listeners (paper, sections 3.2 and 3.3). The
// same for a motion that is being computed and for one that was recorded.

#include <mpi.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/hearing/ears.hpp"
#include "idiophone/hearing/line_of_sight.hpp"
#include "idiophone/parallel/stages.hpp"
#include "idiophone/source/audible_surface.hpp"
#include "idiophone/store/checkpoint.hpp"
#include "idiophone/store/result_file.hpp"
#include "idiophone/surface/emitter.hpp"

namespace idiophone::hearing {

class AudioPath {
 public:
  /// @param scene      whose listeners hear; must outlive this object, as must `stages`
  /// @param steady     audio sample of the steady motion that comes first
  /// @throws std::runtime_error when Embree fails. Collective.
  AudioPath(const scene::Scene& scene, const source::AudibleSurface& surface, std::int64_t steady,
            parallel::Stages& stages, MPI_Comm communicator);

  /// Adds a series for each listener, and the frequencies the sound is expected to have, to a new result. Collective.
  void declare(store::ResultFile& result) const;

  /// The audio sample whose emission makes so many audio samples of sound final.
  [[nodiscard]] std::int64_t completing_sample(std::int64_t samples) const { return samples - ears_.final_before(0); }

  /// Begins after a motion that is taken to have lasted for ever. Collective.
  void start(const surface::SurfaceMotion& steady);

  /// Takes the motion of the next audio sample to all listeners. No communication.
  void hear(const surface::SurfaceMotion& motion);

  /// Why a sound of this rank can't be; it is left out then. Empty where all is well.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }

  /// Writes the audio samples that are final. Collective.
  /// @param most  audio samples in the result at the most
  void write(store::ResultFile& result, std::int64_t most);

  /// Largest magnitude of any audio sample written so far, on rank 0.
  [[nodiscard]] double loudest() const { return loudest_; }

  /// All that decides the future, to a checkpoint and back. Collective.
  /// @param triangles  the rows that this rank's triangles are
  void save(store::CheckpointWriter& checkpoint, const parallel::Rows& triangles);
  void restore(const store::CheckpointReader& checkpoint, const parallel::Rows& triangles);

 private:
  const scene::Scene& scene_;
  parallel::Stages& stages_;
  MPI_Comm communicator_;
  surface::Emitter emitter_;
  surface::Emission emission_;
  Ears ears_;
  std::optional<LineOfSight> line_of_sight_;  ///< none: everything is seen from everywhere
  std::int64_t emitted_;                      ///< the audio sample that was heard last
  std::int64_t written_ = 0;                  ///< audio samples in the result
  double loudest_ = 0.0;
  std::string complaint_;
};

}  // namespace idiophone::hearing
