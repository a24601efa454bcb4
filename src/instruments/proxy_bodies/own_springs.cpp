#include "own_springs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "idiophone/foundation/deck/csv.hpp"
#include "idiophone/foundation/each_once.hpp"

namespace idiophone::proxy_bodies {

namespace {

using Edge = std::pair<Index, Index>;  ///< masses, the smaller number first

std::vector<Edge> edges_of(const proxies::TetrahedralMesh& mesh) {
  std::vector<Edge> edges;
  for (const auto& corners : mesh.tetrahedra) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        edges.push_back(std::minmax({corners[i], corners[j]}));
      }
    }
  }
  keep_each_once(edges);
  return edges;
}

/// The distance of the farther end of an edge from the one of two points that belongs to it, m.
double distance_of(const proxies::TetrahedralMesh& mesh, const Edge& edge, const Vector3& from, const Vector3& to) {
  const Vector3 &a = mesh.nodes[edge.first], &b = mesh.nodes[edge.second];
  const auto farther = [](const Vector3& one, const Vector3& other) { return std::max(one.norm(), other.norm()); };
  return std::min(farther(a - from, b - to), farther(a - to, b - from));
}

/// What is wrong with the values of a row; empty for nothing.
std::string wrong_values(const proxies::OwnSpring& spring) {
  if (!(spring.stiffness > 0.0) || !(spring.length > 0.0)) {
    return "stiffness and length must be above 0";
  }
  return spring.damping < 0.0 ? "the damping must be at least 0" : "";
}

}  // namespace

std::vector<proxies::OwnSpring> own_springs(const std::filesystem::path& file, const proxies::TetrahedralMesh& mesh) {
  constexpr double farthest = 0.5;  // end of a spring from its point, in lengths of the spring
  deck::Mistakes mistakes;
  std::vector<deck::CsvRow> rows;
  deck::read_csv(file,
                 {{"x1", "m"},
                  {"y1", "m"},
                  {"z1", "m"},
                  {"x2", "m"},
                  {"y2", "m"},
                  {"z2", "m"},
                  {"stiffness"},
                  {"damping"},
                  {"length"}},
                 mistakes, rows);
  const std::vector<Edge> edges = edges_of(mesh);
  std::map<Edge, int> lines;  ///< that name an edge
  std::vector<proxies::OwnSpring> springs;
  for (const auto& [where, row] : rows) {
    const Vector3 from(row[0], row[1], row[2]), to(row[3], row[4], row[5]);
    const Edge nearest =
        std::ranges::min(edges, {}, [&](const Edge& edge) { return distance_of(mesh, edge, from, to); });
    const double distance = distance_of(mesh, nearest, from, to);
    if (distance > farthest * (mesh.nodes[nearest.first] - mesh.nodes[nearest.second]).norm()) {
      mistakes.add(where, fmt::format("no spring is between these points; an end of the nearest one is {:.3g} m away",
                                      distance));
    }
    if (const auto [known, is_new] = lines.emplace(nearest, where.line); !is_new) {
      mistakes.add(where, fmt::format("names the same spring as line {}", known->second));
    }
    springs.push_back(
        {.a = nearest.first, .b = nearest.second, .stiffness = row[6], .damping = row[7], .length = row[8]});
    if (const std::string wrong = wrong_values(springs.back()); !wrong.empty()) {
      mistakes.add(where, wrong);
    }
  }
  mistakes.raise();
  return springs;
}

}  // namespace idiophone::proxy_bodies
