#include "outline_checks.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone::sound_maps {

namespace {

using Eigen::Vector2d;

using mesh::Segment;

double cross(const Vector2d& a, const Vector2d& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// Whether the ends of `b` are on different sides of the line through `a`.
bool separates(const Segment& a, const Segment& b) {
  const Vector2d along = a.to - a.from;
  return cross(along, b.from - a.from) * cross(along, b.to - a.from) < 0.0;
}

/// m; 0 if they cross
double distance(const Segment& a, const Segment& b) {
  if (separates(a, b) && separates(b, a)) {
    return 0.0;
  }
  return std::min(
      {mesh::distance(a.from, b), mesh::distance(a.to, b), mesh::distance(b.from, a), mesh::distance(b.to, a)});
}

std::string text_of(const Vector2d& point) {
  return fmt::format("[{:.6g}, {:.6g}]", point[0], point[1]);
}

std::string text_of(const Segment& edge) {
  return fmt::format("the edge from {} to {}", text_of(edge.from), text_of(edge.to));
}

/// The sides of a contour. Those of a circle are inside it, where it is an outline, or around it, where it is a hole.
std::vector<Segment> edges_of(const mesh::Contour& contour, bool is_hole = false) {
  mesh::Contour polygon = contour;
  if (contour.is_circle()) {
    constexpr int sides = 72;
    const double radius = is_hole ? contour.radius / std::cos(std::numbers::pi / sides) : contour.radius;
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      polygon.polygon.push_back(
          {contour.centre[0] + radius * std::cos(angle), contour.centre[1] + radius * std::sin(angle)});
    }
  }
  std::vector<Segment> edges;
  for (std::size_t i = 0; i < polygon.sides(); ++i) {
    edges.push_back(mesh::side_of(polygon, i));
  }
  return edges;
}

/// Largest side of the box around a polygon, m.
double extent_of(const std::vector<Segment>& edges) {
  Eigen::AlignedBox2d box;
  for (const Segment& edge : edges) {
    box.extend(edge.from);
  }
  return box.sizes().maxCoeff();
}

bool check_corners(const deck::Node& node, const std::vector<Segment>& edges, double same, deck::Mistakes& mistakes) {
  for (std::size_t j = 1; j < edges.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      if ((edges[i].from - edges[j].from).norm() > same) {
        continue;
      }
      const bool closes = i == 0 && j + 1 == edges.size();
      return mistakes.add(
          node.children[j],
          fmt::format("this corner, {}, is at the place of corner {}: {}", text_of(edges[j].from), i + 1,
                      closes ? "the polygon closes by itself, so leave the last one out"
                             : "an outline passes each place once, so leave one out"));
    }
  }
  return true;
}

/// Whether edge j, which begins where edge i ends, turns back over it.
bool runs_back(const Segment& i, const Segment& j, double same) {
  return (i.to - i.from).dot(j.to - j.from) < 0.0 &&
         std::min(mesh::distance(j.to, i), mesh::distance(i.from, j)) <= same;
}

bool check_edges(const deck::Node& node, const std::vector<Segment>& edges, double same, deck::Mistakes& mistakes) {
  const std::size_t count = edges.size();
  const auto complain = [&](std::size_t i, std::size_t j, const char* how) {
    return mistakes.add(node.children[j], fmt::format("{} {} {}: the outline must not meet itself", text_of(edges[j]),
                                                      how, text_of(edges[i])));
  };
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t before = (j + count - 1) % count;
    if (runs_back(edges[before], edges[j], same)) {
      return complain(before, j, "runs back over");
    }
    for (std::size_t i = 0; i + 1 < j; ++i) {
      const bool are_neighbours = i == 0 && j + 1 == count;
      if (!are_neighbours && distance(edges[i], edges[j]) <= same) {
        return complain(i, j, "crosses or touches");
      }
    }
  }
  return true;
}

bool meet(const std::vector<Segment>& one, const std::vector<Segment>& other, double same) {
  return std::ranges::any_of(one, [&](const Segment& a) {
    return std::ranges::any_of(other, [&](const Segment& b) { return distance(a, b) <= same; });
  });
}

/// Whether a point is inside a polygon: a ray from it crosses the sides an odd number of times.
bool is_inside(const Vector2d& point, const std::vector<Segment>& edges) {
  bool inside = false;
  for (const Segment& edge : edges) {
    if ((edge.from[1] > point[1]) != (edge.to[1] > point[1])) {
      const double share = (point[1] - edge.from[1]) / (edge.to[1] - edge.from[1]);
      inside ^= edge.from[0] + share * (edge.to[0] - edge.from[0]) > point[0];
    }
  }
  return inside;
}

}  // namespace

bool check_polygon(const deck::Node& node, const std::vector<mesh::Point2>& polygon, deck::Mistakes& mistakes) {
  mesh::Contour contour;
  contour.polygon = polygon;
  const std::vector<Segment> edges = edges_of(contour);
  const double same = 1e-6 * extent_of(edges);
  return check_corners(node, edges, same, mistakes) && check_edges(node, edges, same, mistakes);
}

bool check_holes(const deck::Node& node, const mesh::PlaneRegion& region, deck::Mistakes& mistakes) {
  const std::vector<Segment> outline = edges_of(region.outline);
  const double same = 1e-6 * extent_of(outline);
  std::vector<std::vector<Segment>> holes;
  for (std::size_t j = 0; j < region.holes.size(); ++j) {
    holes.push_back(edges_of(region.holes[j], true));
    const std::vector<Segment>& hole = holes.back();
    if (meet(hole, outline, same) || !is_inside(hole.front().from, outline)) {
      return mistakes.add(node.children[j], "this hole is not inside the outline: it must leave a rim around it");
    }
    if (extent_of(hole) < 100 * same) {
      return mistakes.add(node.children[j],
                          "this hole is smaller than a ten-thousandth of the outline: make it larger, or "
                          "leave it out");
    }
    for (std::size_t i = 0; i < j; ++i) {
      if (meet(hole, holes[i], same) || is_inside(hole.front().from, holes[i]) ||
          is_inside(holes[i].front().from, hole)) {
        return mistakes.add(node.children[j], fmt::format("this hole meets hole {}: make them one", i + 1));
      }
    }
  }
  return true;
}

}  // namespace idiophone::sound_maps
