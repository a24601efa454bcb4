#include "triangles.hpp"
#include "refusal.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace idiophone::mesher {

namespace {

using Edge = std::pair<std::size_t, std::size_t>;

std::string place_of(std::size_t node) {
  std::vector<std::size_t> nodes;
  std::vector<double> places, parametric;
  gmsh::model::mesh::getNodes(nodes, places, parametric);  // getNode has more arguments in later versions of gmsh
  const auto index = static_cast<std::size_t>(std::ranges::find(nodes, node) - nodes.begin());
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", places.at(3 * index), places.at(3 * index + 1),
                     places.at(3 * index + 2));
}

/// How many triangles each edge has.
std::map<Edge, int> edge_uses() {
  constexpr int triangle = 2;  // gmsh's number of the type
  std::vector<std::size_t> tags, nodes;
  gmsh::model::mesh::getElementsByType(triangle, tags, nodes);
  if (tags.empty()) {
    throw Refusal("it has no triangles");
  }
  std::map<Edge, int> uses;
  for (std::size_t first = 0; first + 2 < nodes.size(); first += 3) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(nodes[first + i], nodes[first + (i + 1) % 3]);
      ++uses[{low, high}];
    }
  }
  return uses;
}

/// Requires every edge to have between `fewest` and two triangles.
/// @param fault  what the surface does where it has not
void check_edges(int fewest, const std::string& fault, const std::string& remedy) {
  const std::map<Edge, int> uses = edge_uses();
  const auto is_wrong = [&](const auto& edge) { return edge.second < fewest || edge.second > 2; };
  if (const auto wrong = std::ranges::count_if(uses, is_wrong); wrong > 0) {
    const auto& [edge, count] = *std::ranges::find_if(uses, is_wrong);
    throw Refusal(fmt::format("its surface {} at {} of {} edges; one, of {} triangles, runs from {} to {}. {}", fault,
                              wrong, uses.size(), count, place_of(edge.first), place_of(edge.second), remedy));
  }
}

constexpr double smooth = 40.0 * std::numbers::pi / 180.0;  // facets that meet at less belong to one surface

/// Joins facets to surfaces that can be meshed anew.
void make_smooth_surfaces() {
  gmsh::model::mesh::classifySurfaces(smooth, true, true);
  gmsh::model::mesh::createGeometry();
}

void add_volume_within_surfaces() {
  gmsh::vectorpair surfaces;
  gmsh::model::getEntities(surfaces, 2);
  std::vector<int> tags;
  for (const auto& [dimension, tag] : surfaces) {
    tags.push_back(tag);
  }
  gmsh::model::geo::addVolume({gmsh::model::geo::addSurfaceLoop(tags)});
  gmsh::model::geo::synchronize();
}

}  // namespace

void add_triangles(const std::vector<double>& coordinates, const std::vector<std::size_t>& triangles) {
  std::vector<std::size_t> tags(coordinates.size() / 3);
  std::iota(tags.begin(), tags.end(), std::size_t{1});
  const int surface = gmsh::model::addDiscreteEntity(2);
  gmsh::model::mesh::addNodes(2, surface, tags, coordinates);
  constexpr int triangle = 2;  // gmsh's number of the type
  gmsh::model::mesh::addElementsByType(surface, triangle, {}, triangles);
}

void enclose_triangles() {
  gmsh::model::mesh::removeDuplicateNodes();
  check_edges(2, "isn't closed", how_to_repair);
  make_smooth_surfaces();
  add_volume_within_surfaces();
}

void fill_triangles() {
  constexpr bool with_boundaries = true, to_be_meshed_anew = false;
  gmsh::model::mesh::classifySurfaces(smooth, with_boundaries, to_be_meshed_anew);
  add_volume_within_surfaces();
}

void smooth_triangles() {
  gmsh::model::mesh::removeDuplicateNodes();
  check_edges(1, "branches", "A wall can't");
  make_smooth_surfaces();
}

}  // namespace idiophone::mesher
