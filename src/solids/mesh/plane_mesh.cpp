#include "idiophone/solids/mesh/plane_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <stdexcept>

#include "idiophone/scene/meshing_settings.hpp"
#include "idiophone/solids/mesh/meshing.hpp"
#include "mesher_process.hpp"
#include "plane_script.hpp"

namespace idiophone::mesh {

namespace {

using Corners = std::array<Index, 3>;

/// A geometry file that exists as long as this object. gmsh reads scripts from files only.
class TemporaryScript {
 public:
  explicit TemporaryScript(const std::string& text)
      : folder_((std::filesystem::temp_directory_path() / "idiophone_XXXXXX").string()) {
    if (mkdtemp(folder_.data()) == nullptr || !(std::ofstream(path()) << text).flush()) {
      throw std::runtime_error(fmt::format("can't write {}", path()));
    }
  }
  TemporaryScript(const TemporaryScript&) = delete;
  TemporaryScript& operator=(const TemporaryScript&) = delete;
  TemporaryScript(TemporaryScript&&) = delete;
  TemporaryScript& operator=(TemporaryScript&&) = delete;
  ~TemporaryScript() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  [[nodiscard]] std::string path() const { return folder_ + "/region.geo"; }

 private:
  std::string folder_;
};

/// Straight triangles.
struct Triangles {
  std::vector<Point2> nodes;
  std::vector<Corners> elements;
};

Triangles triangulated(const std::string& script) {
  const TemporaryScript file(script);
  const scene::MeshingSettings settings;
  MeshingRequest request;
  request.file = std::filesystem::canonical(file.path()).string();
  request.dimension = 2;
  request.memory_limit = static_cast<std::uint64_t>(settings.memory_limit);
  const MeshingAnswer answer = run_mesher(request, settings.time_limit);
  for (const Objection& objection : answer.objections) {
    throw std::runtime_error(objection.message);
  }
  if (answer.elements.size() != 1 || answer.elements[0].width != 3 ||
      answer.coordinates.size() != 3 * answer.node_tags.size()) {
    throw std::runtime_error("gmsh makes no triangles of it; does its outline cross itself?");
  }
  std::map<std::uint64_t, std::size_t> places;  // of nodes in the answer
  for (std::size_t i = 0; i < answer.node_tags.size(); ++i) {
    places[answer.node_tags[i]] = i;
  }
  Triangles mesh;
  std::map<std::uint64_t, Index> numbers;  // of nodes that elements use
  const auto& tags = answer.elements[0].node_tags;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const auto [entry, is_new] = numbers.try_emplace(tags[i], static_cast<Index>(mesh.nodes.size()));
    if (is_new) {
      const double* place = &answer.coordinates[3 * places.at(tags[i])];
      mesh.nodes.push_back({place[0], place[1]});
    }
    if (i % 3 == 0) {
      mesh.elements.emplace_back();
    }
    mesh.elements.back()[i % 3] = entry->second;
  }
  for (Corners& corners : mesh.elements) {
    if (twice_area(mesh.nodes[corners[0]], mesh.nodes[corners[1]], mesh.nodes[corners[2]]) < 0.0) {
      std::swap(corners[1], corners[2]);
    }
  }
  return mesh;
}

/// Cuts the triangles at a corner in half towards it, again and again.
void grade(Triangles& mesh, const Point2& corner, int levels) {
  const auto distance = [&](const Point2& node) { return std::hypot(node[0] - corner[0], node[1] - corner[1]); };
  const auto centre = static_cast<Index>(std::ranges::min_element(mesh.nodes, {}, distance) - mesh.nodes.begin());
  for (int level = 0; level < levels; ++level) {
    std::map<Index, Index> middles;  // of the ways from the corner to its neighbours
    const auto middle = [&](Index node) {
      const auto [entry, is_new] = middles.try_emplace(node, static_cast<Index>(mesh.nodes.size()));
      if (is_new) {
        mesh.nodes.push_back(
            {0.5 * (mesh.nodes[node][0] + mesh.nodes[centre][0]), 0.5 * (mesh.nodes[node][1] + mesh.nodes[centre][1])});
      }
      return entry->second;
    };
    const std::size_t count = mesh.elements.size();
    for (std::size_t e = 0; e < count; ++e) {
      auto* const found = std::ranges::find(mesh.elements[e], centre);
      if (found == mesh.elements[e].end()) {
        continue;
      }
      std::rotate(mesh.elements[e].begin(), found, mesh.elements[e].end());
      const auto [_, a, b] = mesh.elements[e];
      const Index near_a = middle(a);
      const Index near_b = middle(b);
      mesh.elements[e] = {centre, near_a, near_b};
      mesh.elements.push_back({near_a, a, b});
      mesh.elements.push_back({near_a, b, near_b});
    }
  }
}

/// The side of a contour that an edge of the mesh is on: the one that is nearest to both ends.
/// @param places  of its ends, m
void find_side(RimEdge& edge, const std::vector<Contour>& contours, const std::array<Eigen::Vector2d, 2>& places) {
  double nearest = std::numeric_limits<double>::infinity();
  const auto compare = [&](std::size_t contour, std::size_t side, const auto& distance_to) {
    const double farther = std::max(distance_to(places[0]), distance_to(places[1]));
    if (farther < nearest) {
      nearest = farther;
      edge.contour = contour;
      edge.side = side;
    }
  };
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const Contour& contour = contours[c];
    if (contour.is_circle()) {
      compare(c, 0, [&](const Eigen::Vector2d& place) {
        return std::abs((place - Eigen::Vector2d::Map(contour.centre.data())).norm() - contour.radius);
      });
    }
    for (std::size_t side = 0; side < contour.polygon.size(); ++side) {
      compare(c, side, [&](const Eigen::Vector2d& place) { return distance(place, side_of(contour, side)); });
    }
  }
}

/// Finds the side of each edge of the rim, and moves the middles of those on circles onto the arcs.
void fit_rim(PlaneMesh& mesh, const std::vector<Contour>& contours) {
  for (RimEdge& edge : mesh.rim) {
    const auto place = [&](Index node) { return Eigen::Vector2d(mesh.nodes[node].data()); };
    find_side(edge, contours, {place(edge.ends[0]), place(edge.ends[1])});
    if (const Contour& contour = contours[edge.contour]; contour.is_circle()) {
      const auto centre = Eigen::Vector2d::Map(contour.centre.data());
      const Eigen::Vector2d on_arc = centre + contour.radius * (place(edge.middle) - centre).normalized();
      mesh.nodes[edge.middle] = {on_arc[0], on_arc[1]};
    }
  }
}

/// Adds the middles of edges, on straight lines, and lists the edges of the rim.
PlaneMesh quadratic(const Triangles& triangles) {
  struct Edge {
    Index middle = 0;
    int triangles = 0;
  };
  PlaneMesh mesh;
  mesh.nodes = triangles.nodes;
  std::map<std::array<Index, 2>, Edge> edges;
  for (const Corners& corners : triangles.elements) {
    auto& nodes = mesh.elements.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
      Edge& edge = edges[{low, high}];
      if (edge.triangles++ == 0) {
        edge.middle = static_cast<Index>(mesh.nodes.size());
        mesh.nodes.push_back(
            {0.5 * (mesh.nodes[low][0] + mesh.nodes[high][0]), 0.5 * (mesh.nodes[low][1] + mesh.nodes[high][1])});
      }
      nodes[i] = corners[i];
      nodes[3 + i] = edge.middle;
    }
  }
  for (const auto& [ends, edge] : edges) {
    if (edge.triangles == 1) {
      mesh.rim.push_back({.ends = ends, .middle = edge.middle});
    }
  }
  return mesh;
}

}  // namespace

PlaneMesh mesh_region(const PlaneRegion& region, double size, int levels) {
  Triangles triangles = triangulated(script_of(region, size));
  for (const Point2& corner : re_entrant_corners(region)) {
    grade(triangles, corner, levels);
  }
  PlaneMesh mesh = quadratic(triangles);
  fit_rim(mesh, region.contours());
  return mesh;
}

}  // namespace idiophone::mesh
