#include "face_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

namespace idiophone::app {

namespace {

std::vector<double> list_of(const Vector3& vector) {
  return {vector.begin(), vector.end()};
}

/// @param nodes  of the face, ascending
nlohmann::json face_facts(const mesh::Mesh& mesh, const std::vector<Index>& nodes) {
  double area = 0.0;
  Vector3 normal = Vector3::Zero();
  for (const auto& [a, b, c] : mesh.outer_surface()) {
    if (std::ranges::all_of(std::array{a, b, c}, [&](Index node) { return std::ranges::binary_search(nodes, node); })) {
      const Vector3 half_cross = 0.5 * (mesh.nodes[b] - mesh.nodes[a]).cross(mesh.nodes[c] - mesh.nodes[a]);
      area += half_cross.norm();
      normal += half_cross;
    }
  }
  Eigen::AlignedBox3d box;
  for (const Index node : nodes) {
    box.extend(mesh.nodes[node]);
  }
  return {{"area", area},
          {"normal", list_of(normal / std::max(area, 1e-300))},
          {"low", list_of(box.min())},
          {"high", list_of(box.max())}};
}

std::string vector_text(const nlohmann::json& vector) {
  std::string text;
  for (const double value : vector) {
    text += fmt::format(" {:>9.4g}", std::abs(value) < 1e-9 ? 0.0 : value);
  }
  return text;
}

}  // namespace

nlohmann::json faces_of(std::span<const scene::Body> bodies, const std::vector<mesh::Mesh>& meshes) {
  nlohmann::json all = nlohmann::json::object();
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    auto& faces = all[bodies[body].name] = nlohmann::json::object();
    for (const auto& [name, nodes] : meshes[body].groups) {
      if (name.starts_with("face_") && bodies[body].mesh.extension() != ".geo" &&
          bodies[body].mesh.extension() != ".msh") {
        faces[name] = face_facts(meshes[body], nodes);
      }
    }
  }
  return all;
}

void print_faces(const nlohmann::json& faces) {
  for (const auto& [body, all] : faces.items()) {
    if (all.empty()) {
      fmt::print("body {}: its file has names of its own, its physical groups\n", body);
      continue;
    }
    fmt::print("body {}\n{:>12} {:>10} {:>30} {:>30} {:>30}\n", body, "group", "area/m2", "mean normal",
               "lowest corner/m", "highest corner/m");
    for (const auto& [name, face] : all.items()) {
      fmt::print("{:>12} {:>10.4g} {} {} {}\n", name, face["area"].get<double>(), vector_text(face["normal"]),
                 vector_text(face["low"]), vector_text(face["high"]));
    }
  }
}

}  // namespace idiophone::app
