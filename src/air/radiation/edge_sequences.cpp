#include "idiophone/air/radiation/edge_sequences.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace idiophone::radiation {

namespace {

constexpr double parallel = 0.9999;  // cosine between normals
constexpr double flat = 1e-3;        // of a distance: from a plane

/// An edge as a way meets it: the first face is on the side that the way comes from.
struct Met {
  std::size_t edge = 0;
  bool turned = false;
  DiffractingEdge placed;
  Vector3 second_normal;  // out of the second face
};

/// A way from an edge to the next one, which is number `to` of those that are met.
struct Link {
  std::size_t to = 0;
  bool over_face = false;
};

/// Whether a part of an edge is behind a plane and not behind another one, so that it is in the shadow of the first
/// face.
bool is_in_shadow(const DiffractingEdge& edge, const Met& of) {
  const double slack = flat * (std::max(edge.length(), of.placed.length()));
  double begin = 0.0, end = 1.0;                                // of the edge
  const auto cut = [&](const Vector3& normal, double offset) {  // keeps what is in front of a plane
    const double first = normal.dot(edge.begin - of.placed.begin) + offset;
    const double last = normal.dot(edge.end - of.placed.begin) + offset;
    if (first * last < 0.0) {
      (first < 0.0 ? begin : end) =
          first < 0.0 ? std::max(begin, first / (first - last)) : std::min(end, first / (first - last));
    } else if (first + last <= 0.0) {
      end = begin - 1.0;
    }
  };
  cut(-of.placed.normal, -slack);
  cut(of.second_normal, slack);
  return (end - begin) * edge.length() > 2.0 * slack;  // more than what the slack lets through
}

/// Whether both edges are edges of one flat face, the second one of `from` and the first one of `to`.
bool share_face(const Met& from, const Met& to) {
  const Vector3 way = to.placed.begin - from.placed.begin;
  return from.second_normal.dot(to.placed.normal) > parallel &&
         std::abs(way.dot(to.placed.normal)) <= flat * way.norm();
}

std::optional<Link> link(const Met& from, const Met& to, std::size_t number, bool same_object) {
  if (from.edge == to.edge) {
    return std::nullopt;
  }
  const bool face = same_object && share_face(from, to);
  const bool thin = std::max(from.placed.angle, to.placed.angle) > 2.0 * std::numbers::pi - 1e-9;
  if ((face && thin) || !is_in_shadow(to.placed, from) ||
      !is_in_shadow(from.placed, {to.edge, !to.turned, to.placed.turned(), to.placed.normal})) {
    return std::nullopt;
  }
  return Link{number, face};
}

bool are_parallel(const DiffractingEdge& one, const DiffractingEdge& other) {
  const double within = std::cos(std::numbers::pi / 6.0);
  return std::abs(one.direction().dot(other.direction())) > within;
}

std::vector<Met> all_met(std::span<const DiffractingEdge> edges) {
  std::vector<Met> met;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const DiffractingEdge turned = edges[i].turned();
    met.push_back({i, false, edges[i], turned.normal});
    met.push_back({i, true, turned, edges[i].normal});
  }
  return met;
}

/// The sequences that go on from others by one edge.
std::vector<EdgeSequence> longer(const std::vector<EdgeSequence>& sequences,
                                 const std::vector<std::vector<Link>>& links, const std::vector<Met>& met) {
  std::vector<EdgeSequence> all;
  for (const EdgeSequence& sequence : sequences) {
    const std::size_t last = sequence.count - 1;
    for (const auto& [to, over_face] : links[2 * sequence.edges.at(last) + (sequence.turned.at(last) ? 1 : 0)]) {
      EdgeSequence& next = all.emplace_back(sequence);
      next.edges.at(sequence.count) = met[to].edge;
      next.turned.at(sequence.count) = met[to].turned;
      next.over_face.at(last) = over_face;
      ++next.count;
    }
  }
  return all;
}

}  // namespace

EdgesInTurn EdgeSequence::placed(std::span<const DiffractingEdge> all) const {
  EdgesInTurn way{.count = count, .over_face = over_face};
  for (std::size_t i = 0; i < count; ++i) {
    way.edges.at(i) = turned.at(i) ? all[edges.at(i)].turned() : all[edges.at(i)];
  }
  return way;
}

std::vector<EdgeSequence> find_edge_sequences(std::span<const DiffractingEdge> edges,
                                              std::span<const std::size_t> objects) {
  const std::vector<Met> met = all_met(edges);
  std::vector<std::vector<Link>> links(met.size()), parallel_links(met.size());
  std::vector<EdgeSequence> alone, oriented;
  for (std::size_t from = 0; from < met.size(); ++from) {
    for (std::size_t to = 0; to < met.size(); ++to) {
      const bool same_object = objects[met[from].edge] == objects[met[to].edge];
      if (const auto next = link(met[from], met[to], to, same_object)) {
        links[from].push_back(*next);
        if (are_parallel(met[from].placed, met[to].placed)) {
          parallel_links[from].push_back(*next);
        }
      }
    }
    oriented.push_back({.edges = {met[from].edge}, .turned = {met[from].turned}});
  }
  std::vector<EdgeSequence> all;
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    all.push_back({.edges = {edge}});  // either side: which face is the first one does not matter
  }
  for (const auto& more :
       {longer(oriented, links, met), longer(longer(oriented, parallel_links, met), parallel_links, met)}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace idiophone::radiation
