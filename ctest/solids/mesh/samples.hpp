#pragma once
// Bodies, files and measures that the mesh tests share.

#include <Eigen/Dense>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"
#include "temporary_file.hpp"

namespace idiophone::mesh {

/// A body with its mesh key at deck.yaml:7:9 and its parameters from line 20 on.
inline scene::Body body_of(const std::filesystem::path& file, element::Type element,
                           const std::map<std::string, double>& parameters = {}) {
  scene::Body body;
  body.name = "plate";
  body.mesh = file;
  body.element = element;
  body.parameters = parameters;
  body.mesh_where = {.file = "deck.yaml", .line = 7, .column = 9};
  int line = 20;
  for (const auto& [name, value] : parameters) {
    body.parameters_where[name] = {.file = "deck.yaml", .line = line++, .column = 1};
  }
  return body;
}

inline scene::Body shipped(const std::string& name, element::Type element,
                           const std::map<std::string, double>& parameters = {}) {
  return body_of(std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "meshes" / name, element, parameters);
}

/// The body where a deck turns and moves it.
inline scene::Body turned_and_moved(scene::Body body) {
  body.rotation = {0.3, -1.0, 0.5};
  body.position = {0.1, 0.2, -3.0};
  return body;
}

/// What read_mesh has to say against a body; "" when nothing.
inline std::string refusal(const scene::Body& body) {
  try {
    static_cast<void>(read_mesh(body));
    return "";
  } catch (const deck::DeckError& error) {
    return error.what();
  }
}

using support::TemporaryFile;

/// Two boxes that share a face, of tetrahedra; `both` holds the two.
inline constexpr const char* two_boxes = R"(
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 0.1, 0.05, 0.05};
Box(2) = {0.1, 0, 0, 0.2, 0.05, 0.05};
Coherence;
Mesh.MeshSizeMax = 0.05;
Physical Volume("core") = {1};
Physical Volume("head") = {2};
Physical Volume("both") = {1, 2};
Physical Surface("skin") = Surface{:};
)";

/// Two rectangles side by side.
inline constexpr const char* two_rectangles = R"(
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 0.1, 0.05};
Rectangle(2) = {0.1, 0, 0, 0.2, 0.05};
Coherence;
Mesh.MeshSizeMax = 0.05;
Physical Surface("left") = {1};
Physical Surface("right") = {2};
)";

/// A material region at a line of deck.yaml.
/// @param thickness  of a layer, m; 0 of a group
inline scene::MaterialRegion region(const std::string& name, int line, double thickness = 0.0) {
  scene::MaterialRegion result;
  result.name = name;
  result.thickness = thickness;
  result.where = {.file = "deck.yaml", .line = line, .column = 5};
  return result;
}

/// A body with a material for each of these groups, from line 10 on.
inline scene::Body with_groups(const TemporaryFile& file, element::Type type, const std::vector<std::string>& groups) {
  scene::Body body = body_of(file.path(), type);
  for (const std::string& group : groups) {
    body.regions.push_back(region(group, 10 + static_cast<int>(body.regions.size())));
  }
  return body;
}

/// An element line of gmsh's MSH 2.2 format, without its number: type, tags, nodes.
using MshElement = std::string;

/// A file in gmsh's MSH 2.2 format, with physical names where given. Nodes and elements are numbered from 1.
inline std::string msh_text(const std::vector<Vector3>& nodes, const std::vector<MshElement>& elements,
                            const std::string& names = "") {
  std::string text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names + "$Nodes\n" + std::to_string(nodes.size()) + "\n";
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    text += std::to_string(i + 1);
    for (const double x : nodes[i]) {
      text += ' ';
      text += std::to_string(x);
    }
    text += "\n";
  }
  text += "$EndNodes\n$Elements\n" + std::to_string(elements.size()) + "\n";
  for (std::size_t i = 0; i < elements.size(); ++i) {
    text += std::to_string(i + 1) + " " + elements[i] + "\n";
  }
  return text + "$EndElements\n";
}

/// The corners of the tetrahedron with three unit edges, of volume 1/6.
inline std::vector<Vector3> unit_corners() {
  return {Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
}

inline std::array<Vector3, 3> corners_of(const Mesh& mesh, const Triangle& triangle) {
  return {mesh.nodes[triangle[0]], mesh.nodes[triangle[1]], mesh.nodes[triangle[2]]};
}

/// Volume within the surface by the divergence theorem, m3: negative when the triangles point inward.
inline double enclosed_volume(const Mesh& mesh) {
  double volume = 0.0;
  for (const auto& triangle : mesh.surface) {
    const auto [a, b, c] = corners_of(mesh, triangle);
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

/// m2
inline double surface_area(const Mesh& mesh) {
  double area = 0.0;
  for (const auto& triangle : mesh.surface) {
    const auto [a, b, c] = corners_of(mesh, triangle);
    area += (b - a).cross(c - a).norm() / 2.0;
  }
  return area;
}

/// Does every edge of a surface triangle meet exactly one neighbour, running the other way?
inline bool is_watertight(const Mesh& mesh) {
  std::map<std::pair<Index, Index>, int> edges;
  for (const auto& [a, b, c] : mesh.surface) {
    ++edges[{a, b}], ++edges[{b, c}], ++edges[{c, a}];
  }
  for (const auto& [edge, count] : edges) {
    const auto opposite = edges.find({edge.second, edge.first});
    if (count != 1 || opposite == edges.end() || opposite->second != 1) {
      return false;
    }
  }
  return true;
}

}  // namespace idiophone::mesh
