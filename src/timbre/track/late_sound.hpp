#pragma once
// The late sound of a room at every listener of a soundtrack.

#include <cstdint>
#include <optional>
#include <vector>

#include "heard_sounds.hpp"
#include "idiophone/air/surface/emission.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/timbre/track/soundtrack.hpp"

namespace idiophone::timbre {

/// What the sources emit reaches the middle of each listener after the travel time, as loud as at 1 m from any
/// distance, and becomes a diffuse field there.
class LateSound {
 public:
  /// @param acoustics  must outlive this object
  /// @param model      of the sources, which do not fall with the distance
  /// @param sources    padded
  /// @param samples    of the whole sound
  LateSound(const scene::Acoustics& acoustics, const timbre::Reverberation& reverberation, PointSources model,
            std::size_t sources, std::int64_t samples);

  /// What sources with a place emit at an audio sample, one after another.
  void hear(std::int64_t sample, const surface::Emission& emission);

  /// What sources without a place emit at an audio sample: it has no way to go.
  void hear_plain(std::int64_t sample, double sound);

  /// Adds the late sound to all listeners; once, when everything was heard.
  void add_to(std::vector<TrackSound>& heard);

 private:
  const scene::Acoustics& acoustics_;
  timbre::Reverberation reverberation_;
  scene::Scene middles_;  // microphones in the middle of each listener, without floor
  std::optional<HeardSounds> ears_;
  std::vector<double> plain_;  // [samples] what feeds all fields at once
};

}  // namespace idiophone::timbre
