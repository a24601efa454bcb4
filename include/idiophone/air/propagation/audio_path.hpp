#pragma once
// From the motion of surfaces to sound: emission, air, listeners (paper, sections 3.2 and 3.3). The same
// for every source.

#include <mpi.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "idiophone/air/propagation/air.hpp"
#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/air/surface/emitter.hpp"
#include "idiophone/foundation/accelerator/accelerator.hpp"
#include "idiophone/foundation/parallel/stages.hpp"
#include "idiophone/scene/acoustics.hpp"

namespace idiophone::propagation {

class AudioPath {
 public:
  /// Collective.
  /// @param acoustics      whose listeners hear; must outlive this object, as must `stages`
  /// @param steady     audio sample of the steady motion that comes first
  /// @param accelerator  which computes waves on a grid, and which no other model uses; it must outlive this object.
  ///                     Null: the processor computes them
  /// @throws std::runtime_error when Embree fails, or the waves do not fit into the memory of the accelerator
  AudioPath(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface, std::int64_t steady,
            parallel::Stages& stages, MPI_Comm communicator, accelerator::Accelerator* accelerator = nullptr);

  [[nodiscard]] std::span<const scene::Listener> listeners() const { return acoustics_.listeners; }
  /// Frequencies that the sound is expected to have.
  [[nodiscard]] std::span<const scene::ReferenceSet> references() const { return acoustics_.references; }
  /// Audio samples per second.
  [[nodiscard]] double rate() const { return acoustics_.audio.rate; }
  /// Of what is heard, e.g. "Pa m".
  [[nodiscard]] std::string unit() const { return air_->unit(); }
  /// What is heard, in one sentence.
  [[nodiscard]] std::string description() const { return air_->description(); }

  /// The audio sample whose emission makes so many audio samples of sound final.
  [[nodiscard]] std::int64_t completing_sample(std::int64_t samples) const { return samples - air_->final_before(0); }

  /// The force of the air on the bodies, which they have to be coupled to before anything begins; null where the deck
  /// does not ask for it.
  [[nodiscard]] propagation::AirLoad* load() { return air_->load(); }

  /// Begins after a motion that is taken to have lasted for ever. Collective.
  void start(const surface::SurfaceMotion& steady);

  /// Takes the motion of the next audio sample to all listeners. No collective call that waits: a problem is kept
  /// until check().
  void hear(const surface::SurfaceMotion& motion);

  /// At the end of a block. Collective.
  /// @throws std::runtime_error, on all ranks, when a sound was not finite or too loud
  void check();

  /// Takes out the audio samples that are final. A problem is kept until check(). Collective.
  /// @param most  audio samples to take out at the most, all calls together
  /// @return [listeners][receivers x samples] on rank 0, a sample's receivers side by side; empty if there is none
  [[nodiscard]] std::vector<std::vector<double>> take(std::int64_t most);

  /// Largest magnitude of any audio sample taken so far, on rank 0.
  [[nodiscard]] double loudest() const { return loudest_; }

  /// All that decides the future. Restoring takes the place of start(). Collective.
  void archive(parallel::Archive& archive);

 private:
  /// Keeps what it throws as problem_, if this is the first problem.
  template <class Action>
  void note_problem(const Action& action);
  void finish();

  scene::Acoustics acoustics_;
  parallel::Stages& stages_;
  MPI_Comm communicator_;
  parallel::Rows triangle_rows_;
  surface::Emitter emitter_;
  surface::Emission emission_;
  std::unique_ptr<Air> air_;
  std::int64_t emitted_;    ///< the audio sample that was heard last
  std::int64_t taken_ = 0;  ///< audio samples taken out
  double loudest_ = 0.0;
  std::string problem_;
};

}  // namespace idiophone::propagation
