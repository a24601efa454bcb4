#pragma once
// The air: from what surfaces emit to what receivers hear (paper, section 3.3). Sound goes along straight paths, or as
// waves on a grid.

#include <cstdint>
#include <string>
#include <vector>

#include "idiophone/air/propagation/air_load.hpp"
#include "idiophone/air/surface/emission.hpp"
#include "idiophone/air/surface/surface_motion.hpp"
#include "idiophone/foundation/parallel/archive.hpp"

namespace idiophone::propagation {

class Air {
 public:
  Air() = default;
  virtual ~Air() = default;
  Air(const Air&) = delete;
  Air& operator=(const Air&) = delete;
  Air(Air&&) = delete;
  Air& operator=(Air&&) = delete;

  /// Of what is heard, e.g. "Pa m".
  [[nodiscard]] virtual std::string unit() const = 0;
  /// What is heard, in one sentence.
  [[nodiscard]] virtual std::string description() const = 0;

  /// Begins after surfaces that are taken to have moved like this for ever. Collective.
  /// @param sample  the audio sample that the motion belongs to
  virtual void start(std::int64_t sample, const surface::SurfaceMotion& steady) = 0;

  /// Its force on the bodies; null where it does not act on them.
  [[nodiscard]] virtual propagation::AirLoad* load() { return nullptr; }

  /// Takes what the surfaces emit at an audio sample to all receivers. No collective call that waits.
  /// What an accelerator computes may still be on its way then, until finish() or the next call.
  /// @param motion  of the same surfaces at the same sample
  /// @throws std::runtime_error when a sound is not finite or too loud to be summed exactly
  virtual void propagate(std::int64_t sample, const surface::Emission& emission,
                         const surface::SurfaceMotion& motion) = 0;

  /// Waits until all that was propagated has reached the receivers.
  /// @throws std::runtime_error as propagate()
  virtual void finish() {}

  /// Audio samples before this one are final once everything emitted up to `sample` was propagated.
  [[nodiscard]] virtual std::int64_t final_before(std::int64_t sample) const = 0;

  /// Takes the next `count` audio samples out, summed over the ranks, from audio sample 0 on. To be called after
  /// finish(). Collective.
  /// @return [listeners][receivers x count] on rank 0, a sample's receivers side by side
  /// @throws std::logic_error if something is still on its way
  [[nodiscard]] virtual std::vector<std::vector<double>> take(std::size_t count) = 0;

  /// All that decides the future. To be called after finish(). Restoring takes the place of start(). Collective.
  /// @throws std::logic_error if something is still on its way
  virtual void archive(parallel::Archive& archive) = 0;
};

}  // namespace idiophone::propagation
