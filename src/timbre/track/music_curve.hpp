#pragma once
// A number of the music over time.

#include <cstdint>
#include <memory>
#include <variant>

#include "idiophone/timbre/language/graph.hpp"
#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"
#include "idiophone/timbre/track/motion_channels.hpp"

namespace idiophone::timbre {

class MusicCurve {
 public:
  /// @param seed  of the random numbers of a tree
  /// @throws as curve_of(); deck::DeckError for a wrong tree
  MusicCurve(const MusicVariable& variable, const SonicScene& scene, const MotionChannels& motion, std::uint64_t seed);

  /// The value at a time (s), which is later than in the call before. A tree is computed at the audio rate of the
  /// scene.
  /// @throws std::runtime_error if it is not finite
  [[nodiscard]] double at(double time);

 private:
  std::variant<double, std::shared_ptr<const Curve>, std::unique_ptr<Graph>> source_ = 0.0;
  int rate_;
  std::int64_t rendered_ = 0;  // samples of a tree
  double last_ = 0.0;          // of them
};

}  // namespace idiophone::timbre
