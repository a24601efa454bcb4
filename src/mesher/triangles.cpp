#include "triangles.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace idiophone::mesher {

namespace {

using Edge = std::pair<std::size_t, std::size_t>;

std::string place_of(std::size_t node) {
  std::vector<double> at, parametric;
  gmsh::model::mesh::getNode(node, at, parametric);
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", at[0], at[1], at[2]);
}

/// Requires every edge to have two triangles, one on each side.
void require_closed() {
  constexpr int triangle = 2;  // gmsh's number of the type
  std::vector<std::size_t> tags, nodes;
  gmsh::model::mesh::getElementsByType(triangle, tags, nodes);
  if (tags.empty()) {
    throw std::runtime_error("it has no triangles");
  }
  std::map<Edge, int> uses;
  for (std::size_t first = 0; first + 2 < nodes.size(); first += 3) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(nodes[first + i], nodes[first + (i + 1) % 3]);
      ++uses[{low, high}];
    }
  }
  const auto is_odd = [](const auto& edge) { return edge.second != 2; };
  if (const auto odd = std::ranges::count_if(uses, is_odd); odd > 0) {
    const auto& [edge, count] = *std::ranges::find_if(uses, is_odd);
    throw std::runtime_error(fmt::format(
        "its surface isn't closed: {} of {} edges have one triangle, or more than two; one with {} runs from {} to {}. "
        "Close holes and remove inner walls in the program that made the file",
        odd, uses.size(), count, place_of(edge.first), place_of(edge.second)));
  }
}

}  // namespace

void enclose_triangles() {
  gmsh::model::mesh::removeDuplicateNodes();
  require_closed();
  gmsh::model::mesh::classifySurfaces(40.0 * std::numbers::pi / 180.0, true, true);
  gmsh::model::mesh::createGeometry();
  gmsh::vectorpair surfaces;
  gmsh::model::getEntities(surfaces, 2);
  std::vector<int> tags;
  for (const auto& [dimension, tag] : surfaces) {
    tags.push_back(tag);
  }
  gmsh::model::geo::addVolume({gmsh::model::geo::addSurfaceLoop(tags)});
  gmsh::model::geo::synchronize();
}

}  // namespace idiophone::mesher
