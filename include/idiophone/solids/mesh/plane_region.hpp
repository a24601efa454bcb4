#pragma once
// Regions of a plane: an outline, and holes in it.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace idiophone::mesh {

using Point2 = std::array<double, 2>;  ///< x and y, m

/// A closed curve: a polygon or a circle.
struct Contour {
  std::vector<Point2> polygon;  ///< corners in order around it, either way, m; empty for a circle
  double radius = 0.0;          ///< of a circle, m
  Point2 centre = {};           ///< of a circle, m

  [[nodiscard]] bool is_circle() const { return polygon.empty(); }
  /// How many sides it has: those of the polygon, or one.
  [[nodiscard]] std::size_t sides() const { return is_circle() ? 1 : polygon.size(); }
};

/// What is inside the outline and outside the holes. They do not meet.
struct PlaneRegion {
  Contour outline;
  std::vector<Contour> holes;

  /// The outline, then the holes.
  [[nodiscard]] std::vector<Contour> contours() const;
};

/// A straight line between two points, m.
struct Segment {
  Eigen::Vector2d from, to;
};

/// Side i of a polygon, from corner i to the next one.
[[nodiscard]] Segment side_of(const Contour& contour, std::size_t side);

/// From a point to the nearest point of a segment whose ends are apart, m.
[[nodiscard]] double distance(const Eigen::Vector2d& point, const Segment& segment);

/// Twice the signed area of a triangle, m2: positive if its corners are counter-clockwise.
[[nodiscard]] double twice_area(const Point2& a, const Point2& b, const Point2& c);

}  // namespace idiophone::mesh
