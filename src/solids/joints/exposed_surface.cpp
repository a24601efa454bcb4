#include "idiophone/solids/joints/exposed_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace idiophone::joints {

namespace {

using Edge = std::pair<Index, Index>;  // of vertices, in the order in which a triangle has them

/// Those that have a triangle on one side only.
std::vector<Edge> open_edges(std::span<const std::array<Index, 3>> triangles) {
  std::vector<Edge> there, back;
  for (const auto& [a, b, c] : triangles) {
    for (const auto& [from, to] : {Edge(a, b), Edge(b, c), Edge(c, a)}) {
      there.emplace_back(from, to);
      back.emplace_back(to, from);
    }
  }
  std::ranges::sort(there);
  std::ranges::sort(back);
  std::vector<Edge> open;
  std::ranges::set_difference(there, back, std::back_inserter(open));
  open.erase(std::unique(open.begin(), open.end()), open.end());
  return open;
}

/// [vertices] The number of the first vertex at open edges that lies at the same place; elsewhere the vertex's own.
std::vector<Index> joined_vertices(const mesh::Part& part, const std::vector<mesh::Triangle>& triangles) {
  constexpr double same_place = 1e-6;  // lengths of the shortest open edge there
  const auto place = [&](Index vertex) -> const Vector3& { return part.reference[part.vertices[vertex]]; };
  std::vector<Index> joined(part.vertices.size());
  std::iota(joined.begin(), joined.end(), 0);
  const std::vector<Edge> open = open_edges(triangles);
  if (open.empty()) {
    return joined;
  }
  std::map<Index, double> reach;  // of the vertices at open edges, m
  for (const auto& [from, to] : open) {
    for (const Index vertex : {from, to}) {
      double& shortest = reach.try_emplace(vertex, std::numeric_limits<double>::infinity()).first->second;
      shortest = std::min(shortest, same_place * (place(to) - place(from)).norm());
    }
  }
  Eigen::AlignedBox3d box;
  for (const auto& [vertex, distance] : reach) {
    box.extend(place(vertex));
  }
  Eigen::Index axis = 0;  // along which the vertices lie farthest apart, so that few have nearly the same coordinate
  box.sizes().maxCoeff(&axis);
  std::vector<std::pair<Index, double>> in_order(reach.begin(), reach.end());
  std::ranges::stable_sort(in_order, {}, [&](const auto& vertex) { return place(vertex.first)[axis]; });
  for (auto one = in_order.begin(); one != in_order.end(); ++one) {
    const Vector3& here = place(one->first);
    const double last = here[axis] + one->second;
    for (auto other = std::next(one); other != in_order.end() && place(other->first)[axis] <= last; ++other) {
      if ((place(other->first) - here).norm() <= one->second) {
        joined[one->first] = joined[other->first] = std::min(joined[other->first], joined[one->first]);
      }
    }
  }
  return joined;
}

}  // namespace

ExposedSurface exposed_surface(const mesh::Part& part, const std::vector<char>& covered) {
  ExposedSurface outer;
  for (std::size_t t = 0; t < part.surface.size(); ++t) {
    if (covered[t] == 0) {
      outer.triangles.push_back(part.surface[t]);
    }
  }
  const std::vector<Index> joined = joined_vertices(part, outer.triangles);
  std::vector<Index> places(part.vertices.size(), -1);  // in `nodes`; -1 of vertices that no triangle has
  for (mesh::Triangle& triangle : outer.triangles) {
    for (Index& vertex : triangle) {
      vertex = joined[vertex];
      places[vertex] = 0;
    }
  }
  for (std::size_t vertex = 0; vertex < places.size(); ++vertex) {
    if (places[vertex] == 0) {
      places[vertex] = static_cast<Index>(outer.nodes.size());
      outer.nodes.push_back(part.vertices[vertex]);
    }
  }
  for (mesh::Triangle& triangle : outer.triangles) {
    std::ranges::for_each(triangle, [&](Index& vertex) { vertex = places[vertex]; });
  }
  return outer;
}

bool is_closed(std::span<const std::array<Index, 3>> triangles) {
  return open_edges(triangles).empty();
}

}  // namespace idiophone::joints
