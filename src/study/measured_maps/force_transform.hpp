#pragma once
// What the force of a blow does to an oscillator.

#include <complex>

#include "idiophone/study/measured_maps/measured_deck.hpp"

namespace idiophone::measured_maps {

/// Integral of F(t) e^(-s t) over the time of a blow, N s. The force is linear between the rows of its table. Where it
/// is less than a fiftieth of the impulse, the blow hardly drives the mode, and nothing can be learned of it: its
/// magnitude is then that fiftieth.
/// @param exponent  s, 1/s
[[nodiscard]] std::complex<double> force_transform(const RecordedBlow& blow, std::complex<double> exponent);

}  // namespace idiophone::measured_maps
