#include "gmsh_extract.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string_view>

#include "group_name.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "spectral_hexahedra.hpp"

namespace idiophone::mesh {

namespace {

/// "elements 3, 4, 5, ..."
std::string first_elements(const ElementBlock& block) {
  constexpr std::size_t at_most = 10;
  const std::span<const std::uint64_t> first =
      std::span(block.element_tags).first(std::min(at_most, block.element_tags.size()));
  return fmt::format("elements {}{}", fmt::join(first, ", "), first.size() < block.element_tags.size() ? ", ..." : "");
}

/// gmsh's name of the elements that the body is made of.
std::string_view family_of(const scene::Body& body) {
  switch (body.element.kind) {
    case element::Kind::tet4:
    case element::Kind::tet10:
      return "Tetrahedron";
    case element::Kind::hex:
      return body.thickness ? "Quadrilateral" : "Hexahedron";
  }
  element::unknown_kind();
}

std::string how_to_get(const scene::Body& body) {
  switch (body.element.kind) {
    case element::Kind::tet4:
    case element::Kind::tet10:
      return "tetrahedra (in a .geo file, leave out Recombine; element: hex computes hexahedra)";
    case element::Kind::hex:
      return body.thickness
                 ? "quadrilaterals of orders 1 to 4 with all their nodes, because it has a thickness (in gmsh, set "
                   "Mesh.RecombineAll = 1, and Mesh.SubdivisionAlgorithm = 1 where triangles remain)"
                 : "hexahedra of orders 1 to 4 with all their nodes (in a .geo file, Recombine and extrude surfaces, "
                   "or use transfinite volumes; element: tet10 computes tetrahedra; thickness makes hexahedra from "
                   "a surface)";
  }
  element::unknown_kind();
}

/// Order of a block of gmsh's elements, if the body can be made of it.
std::optional<int> readable_order(const scene::Body& body, const ElementBlock& block) {
  const std::string_view family = family_of(body);
  switch (body.element.kind) {
    case element::Kind::tet4:
    case element::Kind::tet10:
      return block.type_name.starts_with(family) ? std::optional(element::reference(body.element).gmsh.order)
                                                 : std::nullopt;
    case element::Kind::hex:
      for (int order = lowest_geometry_order; order <= highest_geometry_order; ++order) {
        const int nodes = (order + 1) * (order + 1) * (body.thickness ? 1 : order + 1);
        if (block.type_name == fmt::format("{} {}", family, nodes)) {
          return order;
        }
      }
      return std::nullopt;
  }
  element::unknown_kind();
}

[[noreturn]] void refuse_elements_of(const scene::Body& body, const std::string& what) {
  throw deck::DeckError(body.mesh_where, fmt::format("{} has {}: body '{}' needs {}", body.mesh.string(), what,
                                                     body.name, how_to_get(body)));
}

/// The one order of all elements.
int require_order(const scene::Body& body, const MeshingAnswer& answer) {
  const std::string_view dimension = body.thickness ? "surface" : "volume";
  if (answer.elements.empty()) {
    refuse_elements_of(body, fmt::format("no {} elements (is there a {}, and was it meshed?)", dimension, dimension));
  }
  const auto order = readable_order(body, answer.elements.front());
  for (const ElementBlock& block : answer.elements) {
    const bool is_likely = block.type_name.starts_with(family_of(body));
    if (!is_likely || (answer.elements.size() == 1 && !order)) {
      refuse_elements_of(
          body, fmt::format("{} elements of gmsh's type '{}' ({})", dimension, block.type_name, first_elements(block)));
    }
  }
  if (!order || answer.elements.size() > 1) {
    refuse_elements_of(body, fmt::format("{} elements of different orders", dimension));
  }
  return *order;
}

[[noreturn]] void refuse_answer(const scene::Body& body, const std::string& why) {
  throw deck::DeckError(body.mesh_where, fmt::format("gmsh's mesh of {} makes no sense: {}", body.mesh.string(), why));
}

/// A tag's place in the sorted list of tags. Most files number without gaps, so it is found at once.
Index place_of(const scene::Body& body, std::uint64_t tag, const std::vector<std::size_t>& sorted) {
  const std::size_t likely = sorted.empty() ? 0 : tag - sorted.front();
  if (likely < sorted.size() && sorted[likely] == tag) {
    return static_cast<Index>(likely);
  }
  const auto found = std::ranges::lower_bound(sorted, tag);
  if (found == sorted.end() || *found != tag) {
    refuse_answer(body, fmt::format("there is no node {}", tag));
  }
  return static_cast<Index>(found - sorted.begin());
}

/// Fills the tags, ascending, and the positions of the nodes.
void extract_nodes(const scene::Body& body, const MeshingAnswer& answer, std::vector<std::size_t>& sorted_tags,
                   std::vector<Vector3>& nodes) {
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
    sorted_tags.push_back(tags[place]);
    nodes.push_back(position);
  }
}

/// Appends the nodes of all elements, in our order.
/// @param order  gmsh's place of each of our nodes
void extract_elements(const scene::Body& body, const MeshingAnswer& answer, const std::vector<int>& order,
                      const std::vector<std::size_t>& node_tags, std::vector<std::size_t>& element_tags,
                      std::vector<Index>& elements) {
  for (const ElementBlock& block : answer.elements) {
    if (block.width != std::ssize(order) || block.node_tags.size() != order.size() * block.element_tags.size()) {
      refuse_answer(body, fmt::format("{} nodes for {} elements of type '{}'", block.node_tags.size(),
                                      block.element_tags.size(), block.type_name));
    }
    std::ranges::copy(block.element_tags, std::back_inserter(element_tags));
    elements.reserve(elements.size() + block.node_tags.size());
    for (auto first = block.node_tags.begin(); first != block.node_tags.end(); first += std::ssize(order)) {
      std::ranges::transform(order, std::back_inserter(elements),
                             [&](int place) { return place_of(body, first[place], node_tags); });
    }
  }
}

std::map<std::string, std::vector<Index>> extract_groups(const scene::Body& body, const MeshingAnswer& answer,
                                                         const std::vector<std::size_t>& node_tags) {
  std::map<std::string, std::vector<Index>> groups;
  for (const GroupBlock& group : answer.groups) {
    auto& nodes = groups[name_of(group)];
    for (const auto* tags : {&group.node_tags, &group.triangles}) {
      std::ranges::transform(*tags, std::back_inserter(nodes),
                             [&](std::uint64_t tag) { return place_of(body, tag, node_tags); });
    }
    keep_each_once(nodes);
  }
  return groups;
}

std::map<std::string, std::vector<Triangle>> extract_triangles(const scene::Body& body, const MeshingAnswer& answer,
                                                               const std::vector<std::size_t>& node_tags) {
  std::map<std::string, std::vector<Triangle>> triangles;
  for (const GroupBlock& group : answer.groups) {
    const auto& tags = group.triangles;
    if (tags.size() % 3 != 0) {
      refuse_answer(body, fmt::format("{} nodes for the triangles of group '{}'", tags.size(), name_of(group)));
    }
    for (std::size_t first = 0; first < tags.size(); first += 3) {
      Triangle& triangle = triangles[name_of(group)].emplace_back();
      std::transform(&tags[first], &tags[first] + 3, triangle.begin(),
                     [&](std::uint64_t tag) { return place_of(body, tag, node_tags); });
    }
  }
  return triangles;
}

}  // namespace

GmshMesh extract(const scene::Body& body, const MeshingAnswer& answer) {
  const int order = require_order(body, answer);
  GmshMesh result;
  Mesh& mesh = result.mesh;
  mesh.element = element::with_orders(body.element, {order, order});
  extract_nodes(body, answer, result.node_tags, mesh.nodes);
  extract_elements(body, answer, element::reference(mesh.element).gmsh.nodes, result.node_tags, result.element_tags,
                   mesh.elements);
  mesh.groups = extract_groups(body, answer, result.node_tags);
  mesh.group_triangles = extract_triangles(body, answer, result.node_tags);
  return result;
}

SurfaceMesh extract_surface(const scene::Body& body, const MeshingAnswer& answer) {
  SurfaceMesh result;
  result.order = require_order(body, answer);
  extract_nodes(body, answer, result.node_tags, result.nodes);
  extract_elements(body, answer, element::gmsh_quadrilateral_nodes(result.order), result.node_tags, result.element_tags,
                   result.elements);
  result.groups = extract_groups(body, answer, result.node_tags);
  return result;
}

}  // namespace idiophone::mesh
