#pragma once
// Sounds at points: the attenuation by distance of a sonic scene, and the directivity of its sounds.

#include <functional>
#include <utility>
#include <vector>

#include "idiophone/air/radiation/radiation.hpp"

namespace idiophone::timbre {

/// The pressure of a source is that at 1 m on its axis; it falls with 1/distance, or not at all.
class PointSources : public radiation::Model {
 public:
  enum class Fall { with_distance, none };
  /// Gain of a source by the cosine of the angle off its axis, the emission's normal; empty: 1 in all directions.
  using Pattern = std::function<double(double cosine)>;

  /// @param patterns  [sources]; those without one are the same in all directions
  PointSources(Fall fall, std::vector<Pattern> patterns) : fall_(fall), patterns_(std::move(patterns)) {}

  [[nodiscard]] std::string_view unit() const override { return "Pa"; }
  [[nodiscard]] std::string_view description() const override { return "sound pressure of point sources"; }
  [[nodiscard]] bool shaded_by_own_body() const override { return false; }

  /// @param emission  a triangle for each source, `pressure` at 1 m
  void radiate(const surface::Emission& emission, const radiation::Paths& paths,
               radiation::Arrivals& arrivals) const override {
    const std::size_t count = emission.pressure.size();
    arrivals.sound.resize(count);
    arrivals.change.clear();
    arrivals.delay = paths.delay;
    for (std::size_t s = 0; s < count; ++s) {
      const double distance = fall_ == Fall::none ? 1.0 : paths.distance[s];
      arrivals.sound[s] = paths.gain[s] * emission.pressure[s] / distance;
      if (s < patterns_.size() && patterns_[s]) {
        arrivals.sound[s] *= patterns_[s](paths.cosine[s]);
      }
    }
  }

 private:
  Fall fall_;
  std::vector<Pattern> patterns_;
};

}  // namespace idiophone::timbre
