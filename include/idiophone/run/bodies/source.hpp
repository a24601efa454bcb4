#pragma once
// Whatever moves surfaces: finite elements, a recording, later modes or springs.

#include <cstdint>
#include <vector>

#include "idiophone/air/propagation/air_load.hpp"
#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/air/surface/surface_motion.hpp"
#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/run/bodies/channel.hpp"

namespace idiophone::bodies {

/// Gives the motion of this rank's share of a surface at one audio sample after the other.
class Source {
 public:
  virtual ~Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  Source(Source&&) = delete;
  Source& operator=(Source&&) = delete;

  /// What moves, and the obstacles around it.
  [[nodiscard]] const propagation::AudibleSurface& surface() const { return surface_; }

  /// Audio sample of the steady motion that start() gives, at most 0: low-passes look ahead.
  [[nodiscard]] virtual std::int64_t first_sample() const = 0;

  /// From now on, the air acts on what moves; a motion that is given does not feel it. Before start() or archive().
  /// Collective.
  /// @param air  must outlive this object
  virtual void couple(propagation::AirLoad& /*air*/) {}

  /// Begins with a steady motion, which is taken to have lasted for ever. Collective.
  virtual void start(surface::SurfaceMotion& motion) = 0;

  /// Goes on to the next audio sample. No collective call: a problem is kept until check().
  virtual void advance(surface::SurfaceMotion& motion) = 0;

  /// Its motion channels, noted by start() and advance().
  [[nodiscard]] virtual std::vector<ChannelGroup*> channels() { return {}; }

  /// At the end of a block: whether the motion is still right. Collective.
  /// @throws std::runtime_error, on all ranks, that says what is wrong
  virtual void check() {}

  /// All that decides the future, between two audio samples. Restoring takes the place of start(). Collective.
  virtual void archive(parallel::Archive& archive) = 0;

  /// Audio samples to advance after start() before archive() may be called.
  [[nodiscard]] virtual std::int64_t samples_before_archive() const { return 0; }

  /// What there is to say at the end of a run. Collective.
  virtual void report() const {}

 protected:
  explicit Source(propagation::AudibleSurface surface) : surface_(std::move(surface)) {}

 private:
  propagation::AudibleSurface surface_;
};

}  // namespace idiophone::bodies
