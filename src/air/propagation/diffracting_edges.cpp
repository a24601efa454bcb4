#include "idiophone/air/propagation/diffracting_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace idiophone::propagation {

namespace {

constexpr std::size_t most_edges = 200, most_sequences = 20000;
constexpr std::int64_t names = 2 * most_edges + 1;  // of an edge in a number: each of its sides, and none

void require_few(std::size_t edges, std::size_t sequences) {
  if (edges > most_edges || sequences > most_sequences) {
    throw std::runtime_error(fmt::format(
        "radiation.diffraction: screens, obstacles and bodies have {} edges or more, and {} ways around up to three of "
        "them; at most {} and {} can be followed. Set diffraction to false, or model waves, or leave round and finely "
        "structured things out",
        edges, sequences, most_edges, most_sequences));
  }
}

/// Triangles whose corners at the same place are one vertex.
struct Welded {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<float> positions;  // [3 x vertices] m

  explicit Welded(const std::vector<std::array<Vector3, 3>>& corners) {
    std::map<std::array<float, 3>, Index> vertices;
    for (const auto& triangle : corners) {
      std::array<Index, 3>& numbers = triangles.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3f place = triangle.at(i).cast<float>();
        const auto [vertex, is_new] =
            vertices.try_emplace({place[0], place[1], place[2]}, static_cast<Index>(vertices.size()));
        numbers.at(i) = vertex->second;
        if (is_new) {
          positions.insert(positions.end(), place.begin(), place.end());
        }
      }
    }
  }
};

}  // namespace

DiffractingEdges::DiffractingEdges(const Options& options, const radiation::Visibility& bodies)
    : edges_(options.screens), objects_(edges_.size()), own_(1), mirrors_(options.mirrors) {
  if (options.solids) {
    add_obstacles(options.obstacles);
    add_bodies(bodies);
  }
  find_sequences();
}

void DiffractingEdges::add_obstacles(const std::vector<std::array<Vector3, 3>>& obstacles) {
  const Welded welded(obstacles);
  const radiation::TriangleView surface{welded.triangles, welded.positions};
  for (const radiation::SolidEdge& edge :
       radiation::find_solid_edges(surface, 0, static_cast<Index>(welded.triangles.size()))) {
    edges_.push_back(radiation::placed(edge, surface));
  }
  objects_.resize(edges_.size());
}

void DiffractingEdges::add_bodies(const radiation::Visibility& bodies) {
  const std::span<const Index> first_triangle = bodies.first_triangle();
  for (std::size_t body = 0; body + 1 < first_triangle.size(); ++body) {
    const auto& [first, last] = own_.emplace_back(first_triangle[body], first_triangle[body + 1]);
    for (const radiation::SolidEdge& edge : radiation::find_solid_edges(bodies.view(), first, last)) {
      moving_.push_back({edges_.size(), edge});
      edges_.push_back(radiation::placed(edge, bodies.view()));
    }
    objects_.resize(edges_.size(), body + 1);
  }
}

void DiffractingEdges::find_sequences() {
  require_few(edges_.size(), 0);
  sequences_ = radiation::find_edge_sequences(edges_, objects_);
  require_few(edges_.size(), sequences_.size());
}

void DiffractingEdges::follow(const radiation::Visibility& bodies) {
  for (const auto& [number, edge] : moving_) {
    edges_[number] = radiation::placed(edge, bodies.view());
  }
  if (!moving_.empty()) {
    find_sequences();
  }
}

radiation::EdgesInTurn DiffractingEdges::placed(const radiation::EdgeSequence& sequence, std::size_t copy) const {
  radiation::EdgesInTurn way = sequence.placed(edges_);
  if (copy > 0) {
    for (radiation::DiffractingEdge& edge : way.edges) {
      edge = {mirrored(edge.begin, copy), mirrored(edge.end, copy), mirrors_[copy - 1].mirrored(edge.face),
              mirrors_[copy - 1].mirrored(edge.normal), edge.angle};
    }
  }
  return way;
}

Vector3 DiffractingEdges::mirrored(const Vector3& place, std::size_t copy) const {
  if (copy == 0) {
    return place;
  }
  const radiation::ReflectingPlane& mirror = mirrors_[copy - 1];
  return mirror.at + mirror.mirrored(place - mirror.at);
}

std::int64_t DiffractingEdges::number(const radiation::EdgeSequence& sequence, std::size_t copy) {
  auto number = static_cast<std::int64_t>(copy);
  for (std::size_t i = 0; i < radiation::most_in_turn; ++i) {
    const std::size_t edge = 2 * sequence.edges.at(i) + (sequence.turned.at(i) ? 2 : 1);
    number = names * number + static_cast<std::int64_t>(i < sequence.count ? edge : 0);
  }
  return number;
}

std::size_t DiffractingEdges::copy_of(std::int64_t number) {
  for (std::size_t i = 0; i < radiation::most_in_turn; ++i) {
    number /= names;
  }
  return static_cast<std::size_t>(number);
}

bool DiffractingEdges::is_own(const radiation::EdgeSequence& sequence, Index triangle) const {
  return std::ranges::any_of(std::span(sequence.edges.data(), sequence.count), [&](std::size_t edge) {
    const auto& [first, last] = own_[objects_[edge]];
    return triangle >= first && triangle < last;
  });
}

}  // namespace idiophone::propagation
