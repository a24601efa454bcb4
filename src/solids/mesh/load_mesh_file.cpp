#include "load_mesh_file.hpp"

#include <fmt/format.h>

#include <numeric>
#include <stdexcept>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/solids/mesh/mesh_file.hpp"

namespace idiophone::mesh {

namespace {

/// An element type with its orders, as a deck writes it.
std::string type_text(element::Type type) {
  const element::Orders orders = element::orders(type);
  return element::has_choice_of_orders(type) ? fmt::format("{} with order: {{plane: {}, thickness: {}}}",
                                                           element::name(type), orders.plane, orders.thickness)
                                             : std::string(element::name(type));
}

StoredMesh stored_mesh(const scene::Body& body) {
  try {
    return read_mesh_file(body.mesh);
  } catch (const std::runtime_error& error) {
    throw deck::DeckError(body.mesh_where, fmt::format("body '{}' has no mesh: {}", body.name, error.what()));
  }
}

std::vector<std::size_t> numbers_up_to(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
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

GmshMesh load_mesh_file(const scene::Body& body) {
  require_file(body);
  if (body.thickness) {
    throw deck::DeckError(
        body.thickness_where,
        fmt::format("bodies.{}: thickness and layers have no meaning: {} is a mesh, and a wall has its "
                    "thickness there. Its layers are groups with the names 1, 2, ... for `materials`",
                    body.name, body.mesh.string()));
  }
  StoredMesh stored = stored_mesh(body);
  if (stored.mesh.element != body.element) {
    throw deck::DeckError(body.mesh_where,
                          fmt::format("{} has elements of the type {}, and body '{}' has {}", body.mesh.string(),
                                      type_text(stored.mesh.element), body.name, type_text(body.element)));
  }
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

}  // namespace idiophone::mesh
