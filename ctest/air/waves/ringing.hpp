#pragma once
// A solid in the open whose surface moves in one short pulse, and its sound at any frequency.

#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "idiophone/air/waves/pulse_response.hpp"
#include "vibrating_solid.hpp"

namespace idiophone::waves {

using Complex = std::complex<double>;

/// Air of the tests.
inline constexpr double speed = 343.0;       // m/s
inline constexpr double impedance = 415.03;  // Pa s/m

/// Sound pressure over the velocity of the surface, by [frequency][point], Pa s/m.
using Responses = std::vector<std::vector<Complex>>;

/// Of a place of a surface, m/s.
using NormalVelocity = std::function<double(const Vector3& place, const Vector3& normal)>;

/// Vertices of a solid, shifted, as the grid takes them: [3 x vertices] m.
[[nodiscard]] std::vector<float> positions_of(const radiation::Solid& solid, const Vector3& shift = Vector3::Zero());

/// Mean velocity of each triangle: [triangles].
[[nodiscard]] std::vector<float> shape_of(const radiation::Solid& solid, const NormalVelocity& velocity);

/// How a solid sounds.
struct Ringing {
  const radiation::Solid& solid;
  double cell;  ///< m
  NormalVelocity shape;
};

/// Computes the waves on this rank alone. The surface's velocity is shape times a pulse.
[[nodiscard]] Responses ring(const Ringing& ringing, std::span<const double> frequencies,
                             std::span<const Vector3> points);

/// Mean square of some responses over that of others, dB.
[[nodiscard]] double level(std::span<const Complex> one, std::span<const Complex> other);

}  // namespace idiophone::waves
