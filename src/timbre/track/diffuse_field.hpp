#pragma once
// The late sound of a room at several receivers.

#include <span>
#include <vector>

#include "idiophone/scene/listeners.hpp"
#include "idiophone/timbre/nodes/delay_network.hpp"

namespace idiophone::timbre {

/// Plane waves from all sides, each the output of a delay line of its own. So two places a distance d apart have the
/// coherence of a diffuse field, sin(k d)/(k d) (Cook and others 1955, "Measurement of correlation coefficients in
/// reverberant sound fields"): equal at low frequencies, independent at high ones.
class DiffuseField {
 public:
  /// @param receivers  only the differences of their positions matter; a directional one hears less of the field
  /// @param decay      time of a decay by 60 dB, s, positive
  /// @param speed      of sound, m/s
  DiffuseField(const std::vector<scene::Receiver>& receivers, double decay, double speed, int rate);

  /// The next sample of the room's sound at each receiver, without the direct sound.
  /// @param sounds  [receivers]
  void step(double input, std::span<double> sounds);

 private:
  DelayNetwork lines_;
  std::vector<std::vector<std::size_t>> delays_;  // [receivers][waves] samples after the receiver that it reaches first
  std::vector<std::vector<double>> gains_;        // [receivers][waves]
  std::vector<std::vector<double>> past_;         // [longest delay + 1][waves], a ring
  std::size_t now_ = 0;                           // in past_
};

}  // namespace idiophone::timbre
