#pragma once
// Forces over time: blows by Hertz' law of contact, any function of time, strokes over a rough surface.

#include <cstdint>
#include <functional>
#include <vector>

#include "idiophone/instruments/resonators/force_piece.hpp"
#include "idiophone/instruments/score/action.hpp"

namespace idiophone::resonators {

/// The force over each audio sample as the straight line with the same mean and first moment. In a sample, this is
/// exact for forces that are linear in it; integrals by Gauss' quadrature with sixteen
/// points in the part of the sample in which the force acts.
/// @param force     N, at a time in s
/// @param duration  s, after which the force is zero
[[nodiscard]] ForceCurve sampled(const std::function<double(double time)>& force, double duration, int rate);

/// Force of a rigid hammer with a round head on a body that does not give way: elastic contact by Hertz' law,
/// F = hardness * (approach)^(3/2).
struct HertzPulse {
  double duration = 0.0;  ///< s
  double peak = 0.0;      ///< N

  /// The peak is such that the impulse is exactly 2 mass speed.
  explicit HertzPulse(const score::Hammer& hammer);

  /// peak sin(pi t/duration)^(3/2), N: the usual closed form (W. Goldsmith, Impact, 1960, section 4.2).
  [[nodiscard]] double at(double time) const;
};

/// Force of a tool that is drawn, or a ball that rolls, over a rough surface: the load and what the roughness adds. The
/// tool is a mass on the spring of Hertz' contact, linear about the load. It follows the profile below the contact's
/// own frequency, sqrt(spring/mass), and is left behind above. The profile is a sum of waves with random phases whose
/// power falls as 1/frequency^exponent between the longest and the shortest wavelength. A contact of the size a feels a
/// wave of wavenumber k by the factor exp(-(k a)^2/8). Where the sum would pull, the contact is lost and the force is
/// zero.
/// @return  from start to end of the stroke, N; the load rises and falls over `ramp` at both ends
[[nodiscard]] std::vector<double> stroke_force(const score::Stroke& stroke, std::uint64_t seed, int rate);

}  // namespace idiophone::resonators
