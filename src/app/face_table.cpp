#include "face_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "idiophone/solids/mesh/numbered_faces.hpp"

namespace idiophone::app {

namespace {

std::vector<double> list_of(const Vector3& vector) {
  return {vector.begin(), vector.end()};
}

std::string vector_text(const nlohmann::ordered_json& vector) {
  std::string text;
  for (const double value : vector) {
    text += fmt::format(" {:>9.4g}", std::abs(value) < 1e-9 ? 0.0 : value);
  }
  return text;
}

}  // namespace

nlohmann::ordered_json faces_of(std::span<const scene::Body> bodies, const std::vector<mesh::Mesh>& meshes) {
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    auto& faces = all[bodies[body].name] = nlohmann::ordered_json::object();
    for (const mesh::NumberedFace& face : mesh::numbered_faces(meshes[body], bodies[body])) {
      faces[face.group] = {{"area", face.area},
                           {"normal", list_of(face.normal)},
                           {"low", list_of(face.low)},
                           {"high", list_of(face.high)}};
    }
  }
  return all;
}

void print_faces(const nlohmann::ordered_json& faces) {
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
