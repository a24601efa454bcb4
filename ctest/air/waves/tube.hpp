#pragma once
// Tubes and other solids of revolution, whose inner bottom moves in one pulse, and the sound of the air in them.

#include <array>
#include <optional>
#include <vector>

#include "ringing.hpp"

namespace idiophone::waves {

/// A closed profile in the plane of the axis: distance from the axis and height, m, with the solid on its left.
using Profile = std::vector<std::array<double, 2>>;

/// The solid that a profile sweeps about the z axis.
[[nodiscard]] radiation::Solid revolved(const Profile& profile);

/// Closed at the bottom, whose outside is at z = 0, and of this inner radius, inner length and wall thickness, m.
[[nodiscard]] radiation::Solid closed_tube(double radius, double length, double wall);

/// Pressure at a point of the air, step by step.
struct Recording {
  std::vector<double> pressure;
  double step = 0.0;  ///< s
};

/// @param bottom    height of the surface that moves, m
/// @param cell      edge of a cell, m
/// @param duration  s
/// @param lossy     none: walls take nothing
[[nodiscard]] Recording record(const radiation::Solid& solid, double bottom, double cell, const Vector3& place,
                               double duration, const std::optional<LossyAir>& lossy = {});

/// Spectrum of a part of a recording in Hann's window.
[[nodiscard]] Complex spectrum(const Recording& recording, double start, double length, double frequency);

/// The frequency near another one, by its phase in two parts of the recording: decay does not change it.
[[nodiscard]] double frequency_near(const Recording& recording, double expected, double length);

/// Length that the open end of a pipe adds, of outer radius `outer` (Dalmont, Nederveen and Joly 2001, eq. 32), and its
/// change with frequency (Silva et al. 2009).
[[nodiscard]] double end_correction(double radius, double outer, double frequency);

}  // namespace idiophone::waves
