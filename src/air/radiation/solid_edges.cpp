#include "idiophone/air/radiation/solid_edges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace idiophone::radiation {

namespace {

using std::numbers::pi;

const double sharp = std::cos(pi / 6.0);  // of the angle between the normals of two faces
constexpr double in_line = 0.9999;        // cosine between directions

Vector3 at(const TriangleView& surface, Index vertex) {
  const float* place = &surface.positions[3 * static_cast<std::size_t>(vertex)];
  return {place[0], place[1], place[2]};
}

Vector3 normal_of(const TriangleView& surface, Index triangle) {
  const auto& [a, b, c] = surface.triangles[static_cast<std::size_t>(triangle)];
  return (at(surface, b) - at(surface, a)).cross(at(surface, c) - at(surface, a)).normalized();
}

/// From the line through two vertices to the corner of a triangle that is farthest from it, m.
Vector3 way_beside(const TriangleView& surface, Index triangle, const std::array<Index, 2>& ends) {
  const Vector3 begin = at(surface, ends[0]);
  const Vector3 along = (at(surface, ends[1]) - begin).normalized();
  Vector3 farthest = Vector3::Zero();
  for (const Index corner : surface.triangles[static_cast<std::size_t>(triangle)]) {
    const Vector3 way = at(surface, corner) - begin;
    const Vector3 beside = way - way.dot(along) * along;
    farthest = beside.squaredNorm() > farthest.squaredNorm() ? beside : farthest;
  }
  return farthest;
}

/// Sides of triangles with the triangles that they belong to.
using Sides = std::map<std::array<Index, 2>, std::vector<Index>>;

Sides sides_of(const TriangleView& surface, Index first, Index last) {
  Sides sides;
  for (Index triangle = first; triangle < last; ++triangle) {
    const auto& corners = surface.triangles[static_cast<std::size_t>(triangle)];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(corners.at(i), corners.at((i + 1) % 3));
      sides[{low, high}].push_back(triangle);
    }
  }
  return sides;
}

bool sticks_out(const TriangleView& surface, const std::array<Index, 2>& ends, const std::vector<Index>& triangles) {
  if (triangles.size() != 2) {
    return triangles.size() == 1;
  }
  const Vector3 normal = normal_of(surface, triangles[0]);
  return normal.dot(normal_of(surface, triangles[1])) < sharp &&
         normal.dot(way_beside(surface, triangles[1], ends)) < 0.0;
}

bool are_in_line(const TriangleView& surface, const SolidEdge& edge, const SolidEdge& next) {
  const auto direction = [&](const SolidEdge& one) -> Vector3 {
    return (at(surface, one.ends[1]) - at(surface, one.ends[0])).normalized();
  };
  const auto same_face = [&](std::size_t i, std::size_t k) {
    return normal_of(surface, edge.triangles.at(i)).dot(normal_of(surface, next.triangles.at(k))) > in_line;
  };
  return std::abs(direction(edge).dot(direction(next))) > in_line &&
         ((same_face(0, 0) && same_face(1, 1)) || (same_face(0, 1) && same_face(1, 0)));
}

/// Moves an end of an edge to that of another one that goes on from there, in line and between the same faces.
/// @return  whether it does
bool extend(const TriangleView& surface, SolidEdge& edge, const SolidEdge& next) {
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      if (edge.ends.at(i) == next.ends.at(k) && are_in_line(surface, edge, next)) {
        edge.ends.at(i) = next.ends.at(1 - k);
        return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<SolidEdge> find_solid_edges(const TriangleView& surface, Index first, Index last) {
  std::vector<SolidEdge> edges;
  for (const auto& [ends, triangles] : sides_of(surface, first, last)) {
    if (sticks_out(surface, ends, triangles)) {
      edges.push_back({ends, {triangles.front(), triangles.back()}});
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t k = i + 1; k < edges.size();) {
      if (extend(surface, edges[i], edges[k])) {
        edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(k));
        k = i + 1;  // one before may go on now
      } else {
        ++k;
      }
    }
  }
  return edges;
}

DiffractingEdge placed(const SolidEdge& edge, const TriangleView& surface) {
  const auto& [one, other] = edge.triangles;
  const Vector3 normal = normal_of(surface, one);
  const double between = std::acos(std::clamp(normal.dot(normal_of(surface, other)), -1.0, 1.0));
  return {at(surface, edge.ends[0]), at(surface, edge.ends[1]), way_beside(surface, one, edge.ends).normalized(),
          normal, one == other ? 2.0 * pi : pi + between};
}

}  // namespace idiophone::radiation
