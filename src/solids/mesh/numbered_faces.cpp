#include "idiophone/solids/mesh/numbered_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <sstream>
#include <utility>

#include "idiophone/foundation/each_once.hpp"

namespace idiophone::mesh {

namespace {

constexpr const char* face_prefix = "face_";
constexpr const char* faces_word = "faces ";

/// The numbers that follow a word, if they are all that follows it.
std::optional<std::vector<double>> numbers_after(const std::string& word, const std::string& text, std::size_t count) {
  std::istringstream stream(text);
  std::string first;
  std::vector<double> numbers(count);
  stream >> first;
  for (double& number : numbers) {
    stream >> number;
  }
  const bool complete = first == word && !stream.fail() && (stream >> std::ws).eof();
  return complete ? std::optional(numbers) : std::nullopt;
}

/// The faces with numbers: "faces 3 4"; none if there is no such face.
std::optional<std::vector<bool>> faces_with_numbers(const std::string& name, const std::vector<NumberedFace>& faces) {
  std::istringstream stream(name);
  std::vector<bool> chosen(faces.size(), false);
  std::string number;
  stream >> number;
  while (stream >> number) {
    const auto found = std::ranges::find(faces, face_prefix + number, &NumberedFace::group);
    if (found == faces.end()) {
      return {};
    }
    chosen[static_cast<std::size_t>(found - faces.begin())] = true;
  }
  return chosen;
}

/// Which faces a name describes; none if it is no description.
std::optional<std::vector<bool>> described(const std::string& name, const std::vector<NumberedFace>& faces) {
  if (name.starts_with(faces_word)) {
    return faces_with_numbers(name, faces);
  }
  std::vector<bool> chosen;
  if (const auto numbers = numbers_after("normal", name, 3)) {
    const Vector3 direction = Vector3((*numbers)[0], (*numbers)[1], (*numbers)[2]).normalized();
    const double least = std::cos(5.0 * std::numbers::pi / 180.0);
    for (const NumberedFace& face : faces) {
      chosen.push_back(face.normal.dot(direction) > least);
    }
    return chosen;
  }
  if (const auto numbers = numbers_after("box", name, 6)) {
    Eigen::AlignedBox3d part;
    for (const NumberedFace& face : faces) {
      part.extend(face.low).extend(face.high);
    }
    const double margin = 1e-6 * (faces.empty() ? 0.0 : part.diagonal().norm());
    const Vector3 low((*numbers)[0], (*numbers)[1], (*numbers)[2]), high((*numbers)[3], (*numbers)[4], (*numbers)[5]);
    for (const NumberedFace& face : faces) {
      chosen.push_back((face.low.array() >= low.array() - margin).all() &&
                       (face.high.array() <= high.array() + margin).all());
    }
    return chosen;
  }
  return {};
}

void add_described(Mesh& mesh, const std::string& name, const std::vector<NumberedFace>& faces) {
  const auto chosen = described(name, faces);
  std::vector<Index> nodes;
  for (std::size_t face = 0; chosen && face < faces.size(); ++face) {
    if ((*chosen)[face]) {
      const std::vector<Index>& own = mesh.groups.at(faces[face].group);
      nodes.insert(nodes.end(), own.begin(), own.end());
    }
  }
  if (!nodes.empty()) {
    keep_each_once(nodes);
    mesh.groups.emplace(name, nodes);
  }
}

}  // namespace

std::vector<NumberedFace> numbered_faces(const Mesh& mesh, const scene::Body& body) {
  std::vector<NumberedFace> faces;
  if (body.mesh.extension() == ".geo" || body.mesh.extension() == ".msh") {
    return faces;
  }
  std::map<Index, std::vector<std::size_t>> faces_of_node;
  for (const auto& [name, nodes] : mesh.groups) {
    if (!name.starts_with(face_prefix)) {
      continue;
    }
    Eigen::AlignedBox3d box;
    for (const Index node : nodes) {
      faces_of_node[node].push_back(faces.size());
      box.extend(mesh.nodes[node]);
    }
    faces.push_back({.group = name, .low = box.min(), .high = box.max()});
  }
  for (const auto& [a, b, c] : mesh.outer_surface()) {
    const Vector3 half_cross = 0.5 * (mesh.nodes[b] - mesh.nodes[a]).cross(mesh.nodes[c] - mesh.nodes[a]);
    const auto has = [&](Index node, std::size_t face) {
      return std::ranges::find(faces_of_node[node], face) != faces_of_node[node].end();
    };
    for (const std::size_t face : faces_of_node[a]) {
      if (has(b, face) && has(c, face)) {
        faces[face].area += half_cross.norm();
        faces[face].normal += half_cross;
      }
    }
  }
  for (NumberedFace& face : faces) {
    face.normal /= std::max(face.area, 1e-300);
  }
  // The groups of a mesh are in the order of their names, where face_10 comes before face_2.
  std::ranges::sort(faces, {}, [](const NumberedFace& face) { return std::pair(face.group.size(), face.group); });
  return faces;
}

void add_described_groups(Mesh& mesh, const scene::Body& body) {
  std::vector<std::string> names;
  std::ranges::transform(body.fixed, std::back_inserter(names), &scene::FixedGroup::group);
  std::ranges::transform(body.driven, std::back_inserter(names), &scene::DrivenGroup::group);
  std::erase_if(names, [&](const std::string& name) {
    return mesh.groups.contains(name) ||
           !(name.starts_with(faces_word) || name.starts_with("normal ") || name.starts_with("box "));
  });
  if (names.empty()) {
    return;
  }
  const std::vector<NumberedFace> faces = numbered_faces(mesh, body);
  for (const std::string& name : names) {
    add_described(mesh, name, faces);
  }
}

}  // namespace idiophone::mesh
