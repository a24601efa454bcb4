#include "plane_script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone::mesh {

namespace {

/// Corners of a polygon in the order that has the region on its left.
std::vector<Point2> with_region_on_the_left(std::vector<Point2> polygon, bool is_hole) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += twice_area(polygon[0], polygon[i], polygon[i + 1]);
  }
  if ((sum < 0.0) != is_hole) {
    std::ranges::reverse(polygon);
  }
  return polygon;
}

/// Those of one polygon.
void add_re_entrant(std::vector<Point2>& found, const std::vector<Point2>& polygon) {
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point2& before = polygon[(i + count - 1) % count];
    const Point2& after = polygon[(i + 1) % count];
    const double lengths = std::hypot(polygon[i][0] - before[0], polygon[i][1] - before[1]) *
                           std::hypot(after[0] - polygon[i][0], after[1] - polygon[i][1]);
    if (twice_area(before, polygon[i], after) < -1e-9 * lengths) {
      found.push_back(polygon[i]);
    }
  }
}

/// Writes entities one after another. Points and lines have numbers of their own in gmsh.
class Script {
 public:
  explicit Script(double size) : size_(size), text_(fmt::format("Mesh.MeshSizeMax = {:.17g};\n", size)) {}

  void add_contour(const Contour& contour) {
    loops_.push_back(static_cast<int>(loops_.size()) + 1);
    const std::vector<int> lines = contour.is_circle() ? add_circle(contour) : add_polygon(contour.polygon);
    text_ += fmt::format("Curve Loop({}) = {{{}}};\n", loops_.back(), fmt::join(lines, ", "));
  }

  /// Smaller elements towards these corners.
  void refine_towards(const std::vector<Point2>& corners) {
    std::vector<int> points;
    std::ranges::transform(corners, std::back_inserter(points),
                           [&](const Point2& corner) { return add_point(corner); });
    text_ += fmt::format(
        "Field[1] = Distance;\nField[1].NodesList = {{{}}};\nField[2] = Threshold;\nField[2].IField = 1;\n"
        "Field[2].LcMin = {:.17g};\nField[2].LcMax = {:.17g};\nField[2].DistMin = 0;\nField[2].DistMax = {:.17g};\n"
        "Background Field = 2;\nMesh.MeshSizeExtendFromBoundary = 0;\nMesh.MeshSizeFromPoints = 0;\n",
        fmt::join(points, ", "), 0.02 * size_, size_, 5 * size_);
  }

  [[nodiscard]] std::string meshed() const {
    return text_ + fmt::format("Plane Surface(1) = {{{}}};\nMesh 2;\n", fmt::join(loops_, ", "));
  }

 private:
  int add_point(const Point2& place) {
    text_ += fmt::format("Point({}) = {{{:.17g}, {:.17g}, 0}};\n", ++points_, place[0], place[1]);
    return points_;
  }

  /// Two halves, because gmsh's arcs have less than 180 degrees or as many.
  std::vector<int> add_circle(const Contour& circle) {
    constexpr int fewest_edges = 12;  // of a half
    const auto& [x, y] = circle.centre;
    const int centre = add_point(circle.centre);
    const int right = add_point({x + circle.radius, y});
    const int left = add_point({x - circle.radius, y});
    const int first = ++lines_;
    const int second = ++lines_;
    const int edges = std::max(fewest_edges, static_cast<int>(std::ceil(std::numbers::pi * circle.radius / size_)));
    text_ += fmt::format("Circle({0}) = {{{3}, {2}, {4}}};\nCircle({1}) = {{{4}, {2}, {3}}};\n", first, second, centre,
                         right, left);
    text_ += fmt::format("Transfinite Curve {{{}, {}}} = {};\n", first, second, edges + 1);
    return {first, second};
  }

  std::vector<int> add_polygon(const std::vector<Point2>& polygon) {
    std::vector<int> corners, lines;
    std::ranges::transform(polygon, std::back_inserter(corners),
                           [&](const Point2& corner) { return add_point(corner); });
    for (std::size_t i = 0; i < corners.size(); ++i) {
      lines.push_back(++lines_);
      text_ += fmt::format("Line({}) = {{{}, {}}};\n", lines_, corners[i], corners[(i + 1) % corners.size()]);
    }
    return lines;
  }

  double size_;
  std::string text_;
  int points_ = 0;
  int lines_ = 0;
  std::vector<int> loops_;
};

}  // namespace

std::vector<Point2> re_entrant_corners(const PlaneRegion& region) {
  std::vector<Point2> found;
  add_re_entrant(found, with_region_on_the_left(region.outline.polygon, false));
  for (const Contour& hole : region.holes) {
    add_re_entrant(found, with_region_on_the_left(hole.polygon, true));
  }
  return found;
}

std::string script_of(const PlaneRegion& region, double size) {
  Script script(size);
  for (const Contour& contour : region.contours()) {
    script.add_contour(contour);
  }
  if (const auto corners = re_entrant_corners(region); !corners.empty()) {
    script.refine_towards(corners);
  }
  return script.meshed();
}

}  // namespace idiophone::mesh
