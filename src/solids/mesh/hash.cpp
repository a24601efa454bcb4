#include "hash.hpp"

#include <fmt/format.h>

namespace idiophone::mesh {

std::string Fnv1a::text() const {
  return fmt::format("{:016x}", value_);
}

void add_nodes(const Mesh& mesh, Fnv1a& hash) {
  const int width = element::node_count(mesh.element);
  hash.add(std::span(&width, 1));
  hash.add(std::span(mesh.nodes));
}

void add_surface_and_groups(const Mesh& mesh, Fnv1a& hash) {
  hash.add(std::span(mesh.surface));
  for (const auto& [name, nodes] : mesh.groups) {
    hash.add(std::span(name));
    hash.add(std::span(nodes));
  }
  if (!mesh.regions.empty()) {
    hash.add(std::span(mesh.regions));
  }
}

std::string hash_of(const Mesh& mesh) {
  Fnv1a hash;
  add_nodes(mesh, hash);
  hash.add(std::span(mesh.elements));
  add_surface_and_groups(mesh, hash);
  return hash.text();
}

}  // namespace idiophone::mesh
