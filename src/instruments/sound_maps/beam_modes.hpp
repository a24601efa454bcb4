#pragma once
// Bending of uniform bars (Euler and Bernoulli), in units of their length.

#include "idiophone/instruments/sound_maps/ideal_body.hpp"

namespace idiophone::sound_maps {

/// beta L of the n-th mode, n from 1 on: pi n of supported ends; the n-th root of cos x cosh x = 1 of free or clamped
/// ends, of -1 of clamped_free ones (Kinsler and others, Fundamentals of Acoustics, 3.10).
[[nodiscard]] double beam_root(sound_maps::IdealBody::Ends ends, int n);

/// Shape of the mode with that root, whose mean square is 1.
/// @param x  place over length, 0 to 1
[[nodiscard]] double beam_shape(sound_maps::IdealBody::Ends ends, double root, double x);

}  // namespace idiophone::sound_maps
