#pragma once
// Reflections from walls that absorb some frequencies more than others, as filters: one for each path of the sound.

#include <cstddef>
#include <vector>

namespace idiophone::receivers {

/// Losses in octave bands. Between the centres of two bands, the loss in decibels is linear in the logarithm of the
/// frequency; below the lowest and above the highest it is theirs.
class AbsorbingWalls {
 public:
  /// @param losses  [paths][bands] of the amplitude in all reflections of a path, Np (1 Np is 8.686 dB)
  /// @param lowest  centre of the lowest band, Hz
  /// @param rate    audio samples per second
  AbsorbingWalls(std::vector<std::vector<double>> losses, double lowest, int rate)
      : losses_(std::move(losses)), lowest_(lowest), rate_(rate) {}

  /// Audio samples of a response before and after its middle: 4 ms, half a period at 125 Hz.
  [[nodiscard]] std::size_t half_width() const { return static_cast<std::size_t>(rate_) / 250; }

  /// Amplitude factor of a path at a frequency (Hz).
  [[nodiscard]] double gain(std::size_t path, double frequency) const;

  /// The zero-phase filter of a path: [2 half_width() + 1] taps.
  [[nodiscard]] std::vector<double> response(std::size_t path) const;

 private:
  std::vector<std::vector<double>> losses_;
  double lowest_;
  int rate_;
};

}  // namespace idiophone::receivers
