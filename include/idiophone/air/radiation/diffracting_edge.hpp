#pragma once
// Straight and rigid edges that sound bends around: those of thin screens, and those where two flat faces of a solid
// meet.

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
  /// Unit vector from begin to end.
  [[nodiscard]] Vector3 direction() const { return (end - begin).normalized(); }
  [[nodiscard]] double length() const { return (end - begin).norm(); }
};

/// The edges of a convex polygon.
/// @param corners  in order, m
[[nodiscard]] std::vector<DiffractingEdge> screen_edges(const std::vector<Vector3>& corners);

/// A point in cylindrical coordinates about the line of an edge.
struct PlaceAboutEdge {
  double along;   ///< from the edge's begin, m
  double radius;  ///< m
  double angle;   ///< from the first face, 0 to the edge's
};
[[nodiscard]] PlaceAboutEdge seen_from(const DiffractingEdge& edge, const Vector3& point);

}  // namespace idiophone::radiation
