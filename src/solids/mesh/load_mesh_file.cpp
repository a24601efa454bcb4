#include "load_mesh_file.hpp"

#include <fmt/format.h>

#include <numeric>
#include <stdexcept>

#include "idiophone/files/reading.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/element/deck_keys.hpp"
#include "mesh_outline.hpp"

namespace idiophone::mesh {

namespace {

/// Calls `read()`, whose errors of type std::runtime_error then are refuse_unreadable()'s.
template <class Read>
auto read_for(const scene::Body& body, const Read& read) {
  try {
    return read();
  } catch (const std::runtime_error& error) {
    refuse_unreadable(body, error.what());
  }
}

StoredMesh stored_mesh(const scene::Body& body, Answers& known) {
  if (const auto found = known.stored.find(body.mesh); found != known.stored.end()) {
    return found->second;
  }
  StoredMesh stored = read_for(body, [&] { return read_mesh_file(body.mesh); });
  if (stored.mesh.nodes.size() <= most_kept_nodes) {
    known.stored.emplace(body.mesh, stored);
  }
  return stored;
}

std::vector<std::size_t> numbers_up_to(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

void require_no_thickness(const scene::Body& body) {
  require_file(body);
  if (body.thickness) {
    throw deck::DeckError(body.thickness_where,
                          fmt::format("bodies.{}: thickness and layers have no meaning: {} already contains the "
                                      "thickness. Its layers are groups with the names 1, 2, ... for `materials`",
                                      body.name, body.mesh.string()));
  }
}

void require_element(const scene::Body& body, element::Type type) {
  if (type != body.element) {
    throw deck::DeckError(
        body.mesh_where,
        fmt::format("{} has `{}`, and body '{}' needs `{}`: make it from a body with {}, or give the body "
                    "the element of the file (obstacles are always tet4)",
                    body.mesh.string(), element::deck_keys(type), body.name, element::deck_keys(body.element),
                    element::deck_keys(body.element)));
  }
}

}  // namespace

bool is_mesh_file(const std::filesystem::path& file) {
  return file.extension() == ".h5";
}

void require_file(const scene::Body& body) {
  if (!std::filesystem::is_regular_file(body.mesh)) {
    throw deck::DeckError(body.mesh_where, fmt::format("there is no file {}; the path counts from the deck's folder",
                                                       body.mesh.string()));
  }
}

void refuse_unreadable(const scene::Body& body, const std::string& why) {
  throw deck::DeckError(body.mesh_where, fmt::format("the mesh of body '{}' can't be read: {}", body.name, why));
}

void read_within_limit(const scene::Body& body, const std::function<void()>& read) {
  read_for(body, [&] { files::read_within_limit(body.mesh, read); });
}

GmshMesh load_mesh_file(const scene::Body& body, Answers& known) {
  require_no_thickness(body);
  StoredMesh stored = stored_mesh(body, known);
  require_element(body, stored.mesh.element);
  GmshMesh result;
  result.mesh = std::move(stored.mesh);
  result.node_tags = numbers_up_to(result.mesh.nodes.size());
  result.element_tags = numbers_up_to(result.mesh.element_count());
  for (const auto& [name, elements] : stored.element_groups) {
    result.element_groups[name].assign(elements.begin(), elements.end());
  }
  result.is_stored = true;
  return result;
}

Mesh load_mesh_outline(const scene::Body& body) {
  require_no_thickness(body);
  Mesh outline = read_for(body, [&] { return read_mesh_outline(body.mesh); }).mesh;
  require_element(body, outline.element);
  return outline;
}

}  // namespace idiophone::mesh
