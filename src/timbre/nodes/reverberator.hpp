#pragma once
// The late sound of a room, without its shape, at one place.

#include "idiophone/timbre/nodes/delay_network.hpp"

namespace idiophone::timbre {

/// Eight delay lines, summed with alternating signs.
class Reverberator {
 public:
  /// @param decay  time of a decay by 60 dB, s, positive
  Reverberator(double decay, int rate);

  /// The next sample of the room's sound, without the direct sound.
  double step(double input);

 private:
  DelayNetwork lines_;
};

}  // namespace idiophone::timbre
