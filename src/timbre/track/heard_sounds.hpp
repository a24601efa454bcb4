#pragma once
// What listeners hear of emissions, from the first audio sample to the last.

#include <cstdint>
#include <memory>
#include <vector>

#include "idiophone/air/propagation/ears.hpp"
#include "idiophone/air/surface/emission.hpp"
#include "idiophone/scene/acoustics.hpp"
#include "point_sources.hpp"

namespace idiophone::timbre {

class HeardSounds {
 public:
  /// @param acoustics  must outlive this object
  /// @param emitters   padded
  /// @param samples    of the whole sound
  HeardSounds(const scene::Acoustics& acoustics, std::size_t emitters, PointSources model, std::int64_t samples);

  /// Radiates an emission; once for each audio sample, from 0 on.
  void hear(std::int64_t sample, const surface::Emission& emission);

  /// The same where the emission differs from path to path.
  void hear(std::int64_t sample, const propagation::Ears::EmissionOn& emission_on);

  /// Ears::path_ends() of the first microphone or head.
  [[nodiscard]] std::vector<Vector3> path_ends(std::int64_t sample) const { return ears_.path_ends(sample, 0); }

  /// [listeners][receivers x samples], complete after the last emission.
  [[nodiscard]] const std::vector<std::vector<double>>& sounds() const { return sounds_; }

 private:
  /// Takes what is final out of the ears now and then.
  void take(std::int64_t sample);

  propagation::Ears ears_;
  std::int64_t samples_;
  std::int64_t taken_ = 0;
  std::vector<std::vector<double>> sounds_;
};

}  // namespace idiophone::timbre
