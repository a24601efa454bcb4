#pragma once
// Sounds at points: the attenuation by distance of a sonic scene.

#include "idiophone/air/radiation/radiation.hpp"

namespace idiophone::timbre {

/// The pressure of a source is that at 1 m; it falls with 1/distance in all directions, or not at all.
class PointSources : public radiation::Model {
 public:
  enum class Fall { with_distance, none };
  explicit PointSources(Fall fall) : fall_(fall) {}

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
    }
  }

 private:
  Fall fall_;
};

}  // namespace idiophone::timbre
