#pragma once
// Waves from edges at one frequency.

#include <complex>

#include "idiophone/air/radiation/bend.hpp"

namespace idiophone::radiation {

constexpr double sound_speed = 343.0;  // m/s

/// What edges in turn do to a tone, relative to that of the source at the distance by way of the edges.
/// @param frequency  Hz
[[nodiscard]] std::complex<double> spectrum_of(const Bend& bend, double frequency);

}  // namespace idiophone::radiation
