#pragma once
// A solid in the open whose surface moves in one short pulse, and its sound at any frequency.

#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "idiophone/waves/plan.hpp"
#include "idiophone/waves/wave_field.hpp"
#include "vibrating_solid.hpp"

namespace idiophone::waves {

using Complex = std::complex<double>;

/// Air of the tests.
inline constexpr double speed = 343.0;       // m/s
inline constexpr double impedance = 415.03;  // Pa s/m

/// Sound pressure over the velocity of the surface, by [frequency][point], Pa s/m.
using Responses = std::vector<std::vector<Complex>>;

/// How a solid sounds.
struct Ringing {
  const radiation::Solid& solid;
  double cell;                                                                ///< m
  std::function<double(const Vector3& centre, const Vector3& normal)> shape;  ///< of the normal velocity
  double duration = 0.006;                                                    ///< until the sound has left the grid, s
};

/// Computes the waves on this rank alone. The surface's velocity is shape times a pulse.
[[nodiscard]] Responses ring(const Ringing& ringing, std::span<const double> frequencies,
                             std::span<const Vector3> points);

/// The same with a solid that moves steadily, without a sound of its own, m/s.
[[nodiscard]] Responses ring_in_motion(const Ringing& ringing, const Vector3& velocity,
                                       std::span<const double> frequencies, std::span<const Vector3> points);

/// Mean square of some responses over that of others, dB.
[[nodiscard]] double level(std::span<const Complex> one, std::span<const Complex> other);

}  // namespace idiophone::waves
