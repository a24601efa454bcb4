#pragma once
// Delay lines that feed each other: the memory of artificial reverberation.

#include <cstddef>
#include <span>
#include <vector>

namespace idiophone::timbre {

/// Delay lines of different lengths, each fed by the input and by a reflection of all (Jot and Chaigne 1991, "Digital
/// delay networks for designing artificial reverberators"). Every line loses 60 dB in the decay time, so all of the
/// sound does.
class DelayNetwork {
 public:
  /// @param lengths  of the lines, samples, positive; without common factor, so that echoes do not coincide
  /// @param decay    time of a decay by 60 dB, s, positive
  DelayNetwork(const std::vector<std::size_t>& lengths, double decay, int rate);

  /// Feeds the next sample. @return [lines] what arrives at their ends, until the next call
  std::span<const double> step(double input);

  [[nodiscard]] std::size_t size() const { return lines_.size(); }

 private:
  struct Line {
    std::vector<double> samples;
    std::size_t place = 0;
    double gain = 0.0;
  };
  std::vector<Line> lines_;
  std::vector<double> arriving_;
};

}  // namespace idiophone::timbre
