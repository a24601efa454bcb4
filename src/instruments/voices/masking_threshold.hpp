#pragma once
// Sound that louder sound hides: simultaneous masking by tones, as in psychoacoustic model 1 of MPEG audio (ISO/IEC
// 11172-3:1993, annex D). The threshold in quiet is left out, because nobody knows how loud a sound is played.

#include <array>
#include <cstddef>

namespace idiophone::voices {

class MaskingThreshold {
 public:
  static constexpr std::size_t bins_in_bark = 4;
  static constexpr std::size_t bins = 25 * bins_in_bark;

  /// Critical-band rate z = 13 atan(0.00076 f) + 3.5 atan((f/7500)^2) Bark (E. Zwicker and E. Terhardt, J. Acoust. Soc.
  /// Am. 68, 1980), in bins. @param frequency  Hz
  [[nodiscard]] static std::size_t bin_of(double frequency);

  /// Nothing is hidden.
  void clear() { threshold_.fill(0.0); }

  /// Adds a tone that hides others. @param power  mean square of the pressure, Pa^2
  void add(std::size_t bin, double power);

  /// Mean square of the pressure below which a tone is hidden, Pa^2.
  [[nodiscard]] double at(std::size_t bin) const { return threshold_.at(bin); }

 private:
  std::array<double, bins> threshold_{};
};

}  // namespace idiophone::voices
