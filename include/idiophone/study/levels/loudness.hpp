#pragma once
// Loudness as broadcasters measure it, by libebur128.

#include <optional>
#include <vector>

namespace idiophone::levels {

/// The loudness of a programme (EBU R 128, ITU-R BS.1770-4).
struct Loudness {
  std::optional<double> integrated = std::nullopt;  ///< LUFS; none if the sound is shorter than 0.4 s or too quiet
  std::optional<double> range = std::nullopt;       ///< LU; none if it is shorter than 3 s or too quiet
  std::optional<double> true_peak = std::nullopt;   ///< dB re full scale, between samples, too; none if it is silent
};

/// @param channels    [channels][samples], at least one, all of one length
/// @param rate        samples per second
/// @param full_scale  the value of a sample that is full scale, above 0
/// @return none of it for more than 64 channels and for rates below 16 Hz, which libebur128 does not take
/// @throws std::runtime_error if it has not enough memory
[[nodiscard]] Loudness loudness_of(const std::vector<std::vector<double>>& channels, double rate, double full_scale);

}  // namespace idiophone::levels
