#include "idiophone/solids/mesh/plane_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

#include "idiophone/scene/meshing_limits.hpp"
#include "idiophone/solids/mesh/meshing.hpp"
#include "mesher_process.hpp"

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

/// Twice the signed area of a triangle: positive if its corners are counter-clockwise.
double twice_area(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Corners counter-clockwise.
std::vector<Point2> counter_clockwise(std::vector<Point2> polygon) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += twice_area(polygon[0], polygon[i], polygon[i + 1]);
  }
  if (sum < 0.0) {
    std::ranges::reverse(polygon);
  }
  return polygon;
}

/// Corners at which the region has more than 180 degrees.
std::vector<std::size_t> re_entrant_corners(const std::vector<Point2>& polygon) {
  std::vector<std::size_t> found;
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point2& before = polygon[(i + count - 1) % count];
    const Point2& after = polygon[(i + 1) % count];
    const double lengths = std::hypot(polygon[i][0] - before[0], polygon[i][1] - before[1]) *
                           std::hypot(after[0] - polygon[i][0], after[1] - polygon[i][1]);
    if (twice_area(before, polygon[i], after) < -1e-9 * lengths) {
      found.push_back(i);
    }
  }
  return found;
}

/// gmsh's script of a region, which meshes it itself: triangles, not quadrilaterals.
std::string script_of(const PlaneRegion& region, const std::vector<std::size_t>& re_entrant, double size) {
  std::string script = fmt::format("Mesh.MeshSizeMax = {:.17g};\n", size);
  if (region.polygon.empty()) {
    script += fmt::format(
        "Point(1) = {{0, 0, 0}};\nPoint(2) = {{{0:.17g}, 0, 0}};\nPoint(3) = {{-{0:.17g}, 0, 0}};\n"
        "Circle(1) = {{2, 1, 3}};\nCircle(2) = {{3, 1, 2}};\nCurve Loop(1) = {{1, 2}};\n",
        region.radius);
  } else {
    std::string lines, loop;
    const std::size_t count = region.polygon.size();
    for (std::size_t i = 1; i <= count; ++i) {
      script +=
          fmt::format("Point({}) = {{{:.17g}, {:.17g}, 0}};\n", i, region.polygon[i - 1][0], region.polygon[i - 1][1]);
      lines += fmt::format("Line({0}) = {{{0}, {1}}};\n", i, i % count + 1);
      loop += fmt::format("{}{}", i == 1 ? "" : ", ", i);
    }
    script += fmt::format("{}Curve Loop(1) = {{{}}};\n", lines, loop);
  }
  script += "Plane Surface(1) = {1};\n";
  if (!re_entrant.empty()) {
    std::string points;
    for (const std::size_t corner : re_entrant) {
      points += fmt::format("{}{}", points.empty() ? "" : ", ", corner + 1);
    }
    script += fmt::format(
        "Field[1] = Distance;\nField[1].NodesList = {{{}}};\nField[2] = Threshold;\nField[2].IField = 1;\n"
        "Field[2].LcMin = {:.17g};\nField[2].LcMax = {:.17g};\nField[2].DistMin = 0;\nField[2].DistMax = {:.17g};\n"
        "Background Field = 2;\nMesh.MeshSizeExtendFromBoundary = 0;\nMesh.MeshSizeFromPoints = 0;\n",
        points, 0.02 * size, size, 5 * size);
  }
  return script + "Mesh 2;\n";
}

/// Straight triangles.
struct Triangles {
  std::vector<Point2> nodes;
  std::vector<Corners> elements;
};

Triangles triangulated(const std::string& script) {
  const TemporaryScript file(script);
  const scene::MeshingLimits limits;
  MeshingRequest request;
  request.file = std::filesystem::canonical(file.path()).string();
  request.dimension = 2;
  request.memory_limit = static_cast<std::uint64_t>(limits.memory_limit);
  const MeshingAnswer answer = run_mesher(request, limits.time_limit);
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
void grade(Triangles& mesh, const Point2& corner) {
  constexpr int levels = 14;
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

/// Adds the middles of edges. Those of a disc's rim lie on its circle.
PlaneMesh quadratic(const Triangles& triangles, double radius) {
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
  std::set<Index> rim;
  for (const auto& [ends, edge] : edges) {
    if (edge.triangles == 1) {
      rim.insert({ends[0], ends[1], edge.middle});
      Point2& middle = mesh.nodes[edge.middle];
      const double stretch = radius > 0.0 ? radius / std::hypot(middle[0], middle[1]) : 1.0;
      middle = {stretch * middle[0], stretch * middle[1]};
    }
  }
  mesh.rim.assign(rim.begin(), rim.end());
  return mesh;
}

}  // namespace

PlaneMesh mesh_region(const PlaneRegion& region, double size) {
  const PlaneRegion ordered{counter_clockwise(region.polygon), region.radius};
  const auto re_entrant = re_entrant_corners(ordered.polygon);
  Triangles triangles = triangulated(script_of(ordered, re_entrant, size));
  for (const std::size_t corner : re_entrant) {
    grade(triangles, ordered.polygon[corner]);
  }
  return quadratic(triangles, region.radius);
}

}  // namespace idiophone::mesh
