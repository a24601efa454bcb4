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

  /// Where the first microphone or head is at an audio sample, m.
  [[nodiscard]] Vector3 position(std::int64_t sample) const { return ears_.positions(sample).front(); }

  /// [listeners][receivers x samples], complete after the last emission.
  [[nodiscard]] const std::vector<std::vector<double>>& sounds() const { return sounds_; }

 private:
  propagation::Ears ears_;
  std::int64_t samples_;
  std::int64_t taken_ = 0;
  std::vector<std::vector<double>> sounds_;
};

}  // namespace idiophone::timbre
