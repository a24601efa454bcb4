#pragma once
// Diffraction by the straight edges of thin, flat and rigid screens.
//
// The field of a point source beside a rigid half-plane is exactly that of the source and of its mirror image in the
// plane, each with a wave from the edge (Macdonald, A class of diffraction problems, Proc. London Math. Soc. 14, 1915).
// In time, with R the distance from the receiver to the source or to its image, and L the length of the shortest path
// by way of the edge, the wave from the edge is the direct one (delta(t - R/c)/(4 pi R)) convolved with
//   h = (c R/pi) sqrt(L^2 - R^2) / ((c^2 t^2 - R^2) sqrt(c^2 t^2 - L^2)) for c t > L
// (Friedlander, Sound Pulses, 1958; the limit of a thin wedge in Svensson, Fred and Vanderkooy, JASA 106, 1999). It is
// added where the half-plane is between the receiver and the source (or the image), and subtracted elsewhere.

#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::radiation {

/// An edge of a screen.
struct ScreenEdge {
  Vector3 begin, end;  ///< m
  Vector3 outward;     ///< unit vector in the screen's plane, away from it
  Vector3 normal;      ///< unit vector
};

/// The edges of a convex polygon.
/// @param corners  in order, m
[[nodiscard]] std::vector<ScreenEdge> screen_edges(const std::vector<Vector3>& corners);

/// A wave from an edge, relative to that of a source of the same strength at the receiver's distance by way of the
/// edge: `gain` times edge_response() of `delay`.
struct EdgeWave {
  double gain = 0.0;   ///< negative where it is subtracted
  double delay = 0.0;  ///< s
};

/// What an edge does to the sound from a point to another one.
struct Bend {
  Vector3 apex = Vector3::Zero();  ///< point of the shortest path on the edge, m
  EdgeWave direct, mirrored;       ///< by the source and by its image
  bool exists = false;             ///< whether the apex is on the edge, and the screen's plane between the points
};

/// By an approximation of h that is right at high and at low frequencies, where h is A/2 in all:
/// A sqrt(d)/(2 pi (t + d) sqrt(t)) with t from the arrival by way of the edge. The sum of both waves is within 0.6 dB
/// of the exact one behind the screen. On the other side of the shadow's boundary, where this program has no reflection
/// by the screen, the wave of the image fades out as the detour grows to a tenth of the distance.
/// @param speed  of sound, m/s
[[nodiscard]] Bend find_bend(const ScreenEdge& edge, const Vector3& source, const Vector3& receiver, double speed);

/// Integral of the response sqrt(d)/(2 pi (t + d) sqrt(t)) from the arrival on: arctan(sqrt(t/d))/pi.
/// @param delay  d, above 0; in the unit of the time
[[nodiscard]] double edge_response(double time, double delay);

}  // namespace idiophone::radiation
