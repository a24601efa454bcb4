#include "idiophone/air/propagation/diffracting_edges.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

namespace idiophone::propagation {

namespace {

constexpr std::size_t most_edges = 200, most_ways = 2000;

void require_few(std::size_t edges, std::size_t ways) {
  if (edges > most_edges || ways > most_ways) {
    throw std::runtime_error(fmt::format(
        "radiation.diffraction: obstacles and bodies have {} edges or more, and {} ways around them; at most {} and {} "
        "can be followed. Set diffraction to false, or model waves, or leave round and finely structured things out",
        edges, ways, most_edges, most_ways));
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
    : edges_(options.screens), owners_(edges_.size()), floor_(options.floor) {
  if (options.solids) {
    add_obstacles(options.obstacles);
    add_bodies(bodies);
  }
}

void DiffractingEdges::add_obstacles(const std::vector<std::array<Vector3, 3>>& obstacles) {
  const std::size_t first = edges_.size();
  const Welded welded(obstacles);
  const radiation::TriangleView surface{welded.triangles, welded.positions};
  for (const radiation::SolidEdge& edge :
       radiation::find_solid_edges(surface, 0, static_cast<Index>(welded.triangles.size()))) {
    edges_.push_back(radiation::placed(edge, surface));
  }
  owners_.resize(edges_.size());
  add_pairs(first);
}

void DiffractingEdges::add_bodies(const radiation::Visibility& bodies) {
  const std::span<const Index> first_triangle = bodies.first_triangle();
  for (std::size_t body = 0; body + 1 < first_triangle.size(); ++body) {
    const Owner owner{first_triangle[body], first_triangle[body + 1]};
    const std::size_t first = edges_.size();
    for (const radiation::SolidEdge& edge : radiation::find_solid_edges(bodies.view(), owner.first, owner.last)) {
      moving_.push_back({edges_.size(), edge});
      edges_.push_back(radiation::placed(edge, bodies.view()));
    }
    owners_.resize(edges_.size(), owner);
    add_pairs(first);
  }
}

void DiffractingEdges::add_pairs(std::size_t first) {
  require_few(edges_.size() - first, 0);
  const std::vector<radiation::DiffractingEdge> edges(edges_.begin() + static_cast<std::ptrdiff_t>(first),
                                                      edges_.end());
  for (radiation::EdgePair pair : radiation::find_edge_pairs(edges)) {
    pair.first += first;
    pair.second += first;
    pairs_.push_back(pair);
  }
  require_few(edges_.size(), real_ways());
}

void DiffractingEdges::follow(const radiation::Visibility& bodies) {
  for (const auto& [number, edge] : moving_) {
    edges_[number] = radiation::placed(edge, bodies.view());
  }
}

radiation::DiffractingEdge DiffractingEdges::mirrored(radiation::DiffractingEdge edge) const {
  for (Vector3* place : {&edge.begin, &edge.end}) {
    *place = floor_->at + floor_->mirrored(*place - floor_->at);
  }
  edge.face = floor_->mirrored(edge.face);
  edge.normal = floor_->mirrored(edge.normal);
  return edge;
}

radiation::DiffractingEdge DiffractingEdges::edge(std::size_t way) const {
  const radiation::DiffractingEdge& real = edges_[way % real_ways()];
  return is_mirrored(way) ? mirrored(real) : real;
}

std::array<radiation::DiffractingEdge, 2> DiffractingEdges::pair(std::size_t way) const {
  const auto& [first, second, turned] = pair_of(way);
  std::array pair{turned[0] ? edges_[first].turned() : edges_[first],
                  turned[1] ? edges_[second].turned() : edges_[second]};
  return is_mirrored(way) ? std::array{mirrored(pair[0]), mirrored(pair[1])} : pair;
}

bool DiffractingEdges::is_own(std::size_t way, Index triangle) const {
  const Owner& owner = owners_[is_pair(way) ? pair_of(way).first : way % real_ways()];
  return triangle >= owner.first && triangle < owner.last;
}

}  // namespace idiophone::propagation
