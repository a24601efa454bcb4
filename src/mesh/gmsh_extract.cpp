#include "gmsh_extract.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <span>

#include "hexahedra.hpp"
#include "idiophone/deck/location.hpp"
#include "idiophone/element/reference.hpp"

namespace idiophone::mesh {

namespace {

/// "elements 3, 4, 5, ..."
std::string first_elements(const ElementBlock& block) {
  constexpr std::size_t at_most = 10;
  const std::span<const std::uint64_t> first =
      std::span(block.element_tags).first(std::min(at_most, block.element_tags.size()));
  return fmt::format("elements {}{}", fmt::join(first, ", "), first.size() < block.element_tags.size() ? ", ..." : "");
}

std::string how_to_get(element::Type type) {
  switch (type.kind) {
    case element::Kind::tet4:
    case element::Kind::tet10:
      return "tetrahedra (in a .geo file, leave out Recombine; element: hex computes hexahedra)";
    case element::Kind::hex:
      return "hexahedra of orders 1 to 4 with all their nodes (in a .geo file, Recombine and extrude surfaces, or use "
             "transfinite volumes; element: tet10 computes tetrahedra)";
  }
  element::unknown_kind();
}

/// The element whose numbering a block of gmsh's elements has, if the body can be made of it.
std::optional<element::Type> readable_type(const scene::Body& body, const ElementBlock& block) {
  switch (body.element.kind) {
    case element::Kind::tet4:
    case element::Kind::tet10:
      return block.type_name.starts_with("Tetrahedron") ? std::optional(body.element) : std::nullopt;
    case element::Kind::hex:
      for (int order = lowest_geometry_order; order <= highest_geometry_order; ++order) {
        if (block.type_name == fmt::format("Hexahedron {}", (order + 1) * (order + 1) * (order + 1))) {
          return element::hex(order, order);
        }
      }
      return std::nullopt;
  }
  element::unknown_kind();
}

/// The one type of all elements.
element::Type require_type(const scene::Body& body, const MeshingAnswer& answer) {
  if (answer.elements.empty()) {
    throw deck::DeckError(body.mesh_where,
                          fmt::format("{} has no volume elements: body '{}' needs {} (does the geometry have a volume, "
                                      "and was it meshed in 3-D?)",
                                      body.mesh.string(), body.name, how_to_get(body.element)));
  }
  const auto type = readable_type(body, answer.elements.front());
  for (const ElementBlock& block : answer.elements) {
    if (!type || readable_type(body, block) != type) {
      throw deck::DeckError(
          body.mesh_where,
          fmt::format("{} has volume elements of gmsh's type '{}' ({}): body '{}' needs {}", body.mesh.string(),
                      block.type_name, first_elements(block), body.name, how_to_get(body.element)));
    }
  }
  return *type;
}

[[noreturn]] void refuse_answer(const scene::Body& body, const std::string& why) {
  throw deck::DeckError(body.mesh_where, fmt::format("gmsh's mesh of {} makes no sense: {}", body.mesh.string(), why));
}

/// From tags to places in the sorted list of tags.
std::vector<Index> places_of(const scene::Body& body, const std::vector<std::uint64_t>& tags,
                             const std::vector<std::size_t>& sorted) {
  std::vector<Index> places(tags.size());
  std::ranges::transform(tags, places.begin(), [&](std::uint64_t tag) {
    const auto found = std::ranges::lower_bound(sorted, tag);
    if (found == sorted.end() || *found != tag) {
      refuse_answer(body, fmt::format("there is no node {}", tag));
    }
    return static_cast<Index>(found - sorted.begin());
  });
  return places;
}

void extract_nodes(const scene::Body& body, const MeshingAnswer& answer, GmshMesh& result) {
  const auto& tags = answer.node_tags;
  const auto& coordinates = answer.coordinates;
  if (coordinates.size() != 3 * tags.size()) {
    refuse_answer(body, fmt::format("{} coordinates for {} nodes", coordinates.size(), tags.size()));
  }
  if (tags.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max())) {
    throw deck::DeckError(body.mesh_where,
                          fmt::format("{} has {} nodes, more than the {} that can be numbered", body.mesh.string(),
                                      tags.size(), std::numeric_limits<Index>::max()));
  }
  std::vector<std::size_t> order(tags.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t place) { return tags[place]; });
  for (const std::size_t place : order) {
    const Vector3 position(coordinates[3 * place], coordinates[3 * place + 1], coordinates[3 * place + 2]);
    if (!position.allFinite()) {
      throw deck::DeckError(body.mesh_where,
                            fmt::format("node {} of {} is at ({}, {}, {}), which isn't a place", tags[place],
                                        body.mesh.string(), position.x(), position.y(), position.z()));
    }
    result.node_tags.push_back(tags[place]);
    result.mesh.nodes.push_back(position);
  }
}

void extract_elements(const scene::Body& body, const MeshingAnswer& answer, GmshMesh& result) {
  const std::vector<int>& order = element::reference(result.mesh.element).gmsh.nodes;
  for (const ElementBlock& block : answer.elements) {
    if (block.width != std::ssize(order) || block.node_tags.size() != order.size() * block.element_tags.size()) {
      refuse_answer(body, fmt::format("{} nodes for {} elements of type '{}'", block.node_tags.size(),
                                      block.element_tags.size(), block.type_name));
    }
    std::ranges::copy(block.element_tags, std::back_inserter(result.element_tags));
    const std::vector<Index> nodes = places_of(body, block.node_tags, result.node_tags);
    for (auto first = nodes.begin(); first != nodes.end(); first += std::ssize(order)) {
      std::ranges::transform(order, std::back_inserter(result.mesh.elements), [&](int place) { return first[place]; });
    }
  }
}

void extract_groups(const scene::Body& body, const MeshingAnswer& answer, GmshMesh& result) {
  for (const GroupBlock& group : answer.groups) {
    auto& nodes = result.mesh.groups[group.name.empty() ? std::to_string(group.tag) : group.name];
    std::ranges::copy(places_of(body, group.node_tags, result.node_tags), std::back_inserter(nodes));
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }
}

}  // namespace

GmshMesh extract(const scene::Body& body, const MeshingAnswer& answer) {
  GmshMesh result;
  result.mesh.element = require_type(body, answer);
  extract_nodes(body, answer, result);
  extract_elements(body, answer, result);
  extract_groups(body, answer, result);
  return result;
}

}  // namespace idiophone::mesh
