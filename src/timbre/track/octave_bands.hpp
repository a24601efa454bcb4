#pragma once
// A sound in octave bands, for directivities that differ from band to band.

#include <array>
#include <cstddef>
#include <vector>

#include "idiophone/foundation/spectra/convolver.hpp"
#include "idiophone/scene/room_section.hpp"

namespace idiophone::timbre {

/// Filters without a shift of phase, whose sum passes everything unchanged. The gain of each is 1 at its centre and
/// falls to 0 at the next centres, linearly in the logarithm of the frequency. The lowest one passes all below its
/// centre, the highest one all above.
class OctaveBands {
 public:
  static constexpr std::size_t count = scene::OctaveBands().size();

  explicit OctaveBands(int rate);

  /// Audio samples that the input is ahead of the output: four periods of the lowest centre.
  [[nodiscard]] static std::size_t lead(int rate);

  /// The bands of the sample that was given `lead` samples ago.
  [[nodiscard]] std::array<double, count> step(double input);

 private:
  std::vector<spectra::Convolver> filters_;  // [bands]
};

}  // namespace idiophone::timbre
