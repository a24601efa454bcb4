#include "outline_checks.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace idiophone::sound_maps {

namespace {

using Eigen::Vector2d;

/// A straight edge of an outline.
struct Segment {
  Vector2d from, to;  ///< m
};

double cross(const Vector2d& a, const Vector2d& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// m
double distance(const Vector2d& point, const Segment& segment) {
  const Vector2d along = segment.to - segment.from;
  const double share = std::clamp(along.dot(point - segment.from) / along.squaredNorm(), 0.0, 1.0);
  return (segment.from + share * along - point).norm();
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
  return std::min({distance(a.from, b), distance(a.to, b), distance(b.from, a), distance(b.to, a)});
}

std::string text_of(const Vector2d& point) {
  return fmt::format("[{:.6g}, {:.6g}]", point[0], point[1]);
}

std::string text_of(const Segment& edge) {
  return fmt::format("the edge from {} to {}", text_of(edge.from), text_of(edge.to));
}

/// Edge i goes from corner i to the next one.
std::vector<Segment> edges_of(const std::vector<mesh::Point2>& polygon) {
  std::vector<Segment> edges;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    edges.push_back({Vector2d::Map(polygon[i].data()), Vector2d::Map(polygon[(i + 1) % polygon.size()].data())});
  }
  return edges;
}

/// Largest side of the box around a polygon, m.
double extent_of(const std::vector<Segment>& edges) {
  Vector2d low = edges.front().from;
  Vector2d high = low;
  for (const Segment& edge : edges) {
    low = low.cwiseMin(edge.from);
    high = high.cwiseMax(edge.from);
  }
  return (high - low).maxCoeff();
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
  return (i.to - i.from).dot(j.to - j.from) < 0.0 && std::min(distance(j.to, i), distance(i.from, j)) <= same;
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

}  // namespace

bool check_polygon(const deck::Node& node, const std::vector<mesh::Point2>& polygon, deck::Mistakes& mistakes) {
  const std::vector<Segment> edges = edges_of(polygon);
  const double same = 1e-6 * extent_of(edges);
  return check_corners(node, edges, same, mistakes) && check_edges(node, edges, same, mistakes);
}

}  // namespace idiophone::sound_maps
