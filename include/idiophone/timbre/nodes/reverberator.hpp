#pragma once
// The late sound of a room, without its shape: a network of delays.

#include <array>
#include <cstddef>
#include <vector>

namespace idiophone::timbre {

/// Eight delay lines of different lengths, each fed by a reflection of all (Jot and Chaigne 1991, "Digital delay
/// networks for designing artificial reverberators"). Every line loses 60 dB in the decay time, so all of the sound
/// does.
class Reverberator {
 public:
  /// @param decay  time of a decay by 60 dB, s, positive
  Reverberator(double decay, int rate);

  /// The next sample of the room's sound, without the direct sound.
  double step(double input);

 private:
  struct Line {
    std::vector<double> samples;
    std::size_t place = 0;
    double gain = 0.0;
  };
  static constexpr std::size_t line_count = 8;
  std::array<Line, line_count> lines_;
};

}  // namespace idiophone::timbre
