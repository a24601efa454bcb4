#pragma once
// Diffraction by straight and rigid edges: those of thin screens, and those where two flat faces of a solid meet.
//
// The field of a point source beside a rigid wedge is that of the source and of its mirror images, each with a wave
// from the edge. Behind a half-plane they are Macdonald's (A class of diffraction problems, Proc. London Math. Soc. 14,
// 1915). For any wedge, Svensson, Fred and Vanderkooy give them in time (JASA 106, 1999). Pierce has one function of
// one variable for all of them, right at high frequencies and where the shadow begins, and the product of two such
// functions for two edges in turn (Diffraction of sound around corners and over wide barriers, JASA 55, 1974).

#include <array>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::radiation {

/// An edge between two faces. Of a screen, they are its two sides.
struct DiffractingEdge {
  Vector3 begin, end;  ///< m
  Vector3 face;        ///< unit vector in the first face, away from the edge and normal to it
  Vector3 normal;      ///< unit vector out of the first face
  double angle;        ///< from the first face through the air to the second, above pi, at most 2 pi

  /// The same edge with its faces exchanged.
  [[nodiscard]] DiffractingEdge turned() const;
  /// Unit vector away from both faces.
  [[nodiscard]] Vector3 outward() const;
};

/// The edges of a convex polygon.
/// @param corners  in order, m
[[nodiscard]] std::vector<DiffractingEdge> screen_edges(const std::vector<Vector3>& corners);

/// A wave from an edge, relative to that of a source of the same strength at the receiver's distance by way of the
/// edge: `gain` times edge_response() of `delay`.
struct EdgeWave {
  double gain = 0.0;   ///< negative where it is subtracted
  double delay = 0.0;  ///< s
};

/// What an edge does to the sound from a point to another one.
struct Bend {
  Vector3 apex = Vector3::Zero();  ///< point of the shortest path on the edge, m
  EdgeWave direct, mirrored;       ///< by the source and by its images
  bool exists = false;             ///< whether the apex is on the edge, and there is a wave
};

/// Each wave is A sqrt(d)/(2 pi (t + d) sqrt(t)), t from the arrival by way of the edge: A/2 in all. d gives Pierce's
/// high frequencies. Pierce has A = 1; here A is between that and what makes frequency 0 right, and 1 where the shadow
/// begins. The sum of both waves is within 0.6 dB of the exact one behind a screen, and within 1.6 dB behind a right
/// angle. On the other side of the
/// shadow's boundary, where this program has no reflection by the faces, both waves fade out as the detour grows to a
/// tenth of the distance.
/// @param speed  of sound, m/s
[[nodiscard]] Bend find_bend(const DiffractingEdge& edge, const Vector3& source, const Vector3& receiver, double speed);

/// What two edges of one flat face do to the sound that goes over one and then the other.
struct DoubleBend {
  std::array<Vector3, 2> apexes = {Vector3::Zero(), Vector3::Zero()};  ///< points of the shortest path, m
  double gain = 0.0;                  ///< as that of EdgeWave, times edge_response() of one delay and then the other
  std::array<double, 2> delays = {};  ///< s
  bool exists = false;                ///< whether the apexes are on the edges, and there is a wave
};

/// Pierce's product, with the waves of find_bend().
/// @param first, second  turned so that their first face is the one between them
[[nodiscard]] DoubleBend find_double_bend(const DiffractingEdge& first, const DiffractingEdge& second,
                                          const Vector3& source, const Vector3& receiver, double speed);

/// Integral of the response sqrt(d)/(2 pi (t + d) sqrt(t)) from the arrival on: arctan(sqrt(t/d))/pi.
/// @param delay  d, above 0; in the unit of the time
[[nodiscard]] double edge_response(double time, double delay);

}  // namespace idiophone::radiation
