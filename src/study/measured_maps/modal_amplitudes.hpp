#pragma once
// Amplitudes of modes in recordings of blows at several points, as products of what a blow does and what is heard.

#include <complex>
#include <span>
#include <vector>

namespace idiophone::measured_maps {

/// Pressure of a mode after a blow of 1 N s, at the time when the sound arrives, Pa: [blows][microphones].
using Heard = std::vector<std::vector<std::complex<double>>>;

/// Finds by how much the times of blows are wrong, and corrects the phases. The shape of a mode is real, so its phase
/// at a microphone is the same after all blows, or opposite. A common delay of all modes of a recording is sought that
/// makes it so, within 1.5 ms. The strongest recording stays as it is.
/// @param heard      [modes]
/// @param frequency  [modes] Hz
/// @param fixed      [blows] whether the time of the blow is known
void align(std::vector<Heard>& heard, std::span<const double> frequency, const std::vector<bool>& fixed);

/// One mode, whose pressures are nearest to strength[blow] pressure[microphone].
struct SeparatedMode {
  std::vector<double> strength;                ///< [blows] with the mean square 1
  std::vector<std::complex<double>> pressure;  ///< [microphones]
};

/// Least squares, by alternating between both factors.
[[nodiscard]] SeparatedMode separate(const Heard& heard);

}  // namespace idiophone::measured_maps
