#pragma once
// Diffraction of sound by edges.
//
// The field of a point source beside a rigid wedge is that of the source and of its mirror images, each with a wave
// from the edge. Behind a half-plane they are Macdonald's (A class of diffraction problems, Proc. London Math. Soc. 14,
// 1915). For any wedge, Svensson, Fred and Vanderkooy give them in time (JASA 106, 1999). Pierce has one function of
// one variable for all of them, right at high frequencies and where the shadow begins, and the product of two such
// functions for two edges in turn (Diffraction of sound around corners and over wide barriers, JASA 55, 1974).

#include <array>

#include "idiophone/air/radiation/shortest_way.hpp"

namespace idiophone::radiation {

/// A wave from an edge, relative to that of a source of the same strength at the receiver's distance by way of the
/// edge: `gain` times edge_response() of `delay`.
struct EdgeWave {
  double gain = 0.0;   ///< negative where it is subtracted
  double delay = 0.0;  ///< s
};

/// Edges that a way goes around, one after the other. If there are several, the way comes from the side of the first
/// face of each.
struct EdgesInTurn {
  std::array<DiffractingEdge, most_in_turn> edges = {};
  std::size_t count = 1;
  std::array<bool, most_in_turn - 1> over_face = {};  ///< whether the way from an edge to the next is on a face of both
};

/// What edges in turn do to the sound from a point to another one.
struct Bend {
  std::array<Vector3, most_in_turn> apexes;  ///< points of the shortest way on the edges, m
  double gain = 0.0;                         ///< of all waves; 0: there is no such way
  /// Of each edge: by what comes to it, and by the image of that. They are alike if one side of the way is on a face;
  /// then they are one wave.
  std::array<std::array<EdgeWave, 2>, most_in_turn> waves = {};
};

/// Each wave is A sqrt(d)/(2 pi (t + d) sqrt(t)), t from the arrival by way of the edge: A/2 in all. d gives Pierce's
/// high frequencies. Pierce has A = 1; here A is between that and what makes frequency 0 right, and 1 where the shadow
/// begins. The sum of both waves is within 0.6 dB of the exact one behind a screen, and within 1.6 dB behind a right
/// angle. On the other side of the shadow's boundary, where this program has no reflection by the faces, both waves
/// fade out as the detour grows to a tenth of the distance. Edges in turn multiply, as Pierce's two do.
/// @param speed  of sound, m/s
[[nodiscard]] Bend find_bend(const EdgesInTurn& way, const Vector3& source, const Vector3& receiver, double speed);

/// Integral of the response sqrt(d)/(2 pi (t + d) sqrt(t)) from the arrival on: arctan(sqrt(t/d))/pi.
/// @param delay  d, above 0; in the unit of the time
[[nodiscard]] double edge_response(double time, double delay);

}  // namespace idiophone::radiation
