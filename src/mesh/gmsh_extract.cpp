#include "gmsh_extract.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "idiophone/deck/location.hpp"
#include "idiophone/element/reference.hpp"

namespace idiophone::mesh {

namespace {

int gmsh_type(element::Type type) {
  const element::GmshElement& gmsh = element::reference(type).gmsh;
  return gmsh::model::mesh::getElementType(gmsh.family, gmsh.order);
}

std::vector<int> volume_element_types() {
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types, 3);
  return types;
}

void require_tetrahedra(const scene::Body& body) {
  const auto types = volume_element_types();
  if (types.empty()) {
    throw deck::DeckError(body.mesh_where,
                          fmt::format("{} has no volume elements: body '{}' needs tetrahedra (does the geometry have "
                                      "a volume, and was it meshed in 3-D?)",
                                      body.mesh.string(), body.name));
  }
  for (const int type : types) {
    std::string name;
    int dimension = 0, order = 0, nodes = 0, corners = 0;
    std::vector<double> positions;
    gmsh::model::mesh::getElementProperties(type, name, dimension, order, nodes, positions, corners);
    if (!name.starts_with("Tetrahedron")) {
      throw deck::DeckError(body.mesh_where,
                            fmt::format("{} has volume elements of gmsh's type '{}': only tetrahedra can be computed "
                                        "(in a .geo file, leave out Recombine)",
                                        body.mesh.string(), name));
    }
  }
}

/// From tags to places in the sorted list of tags.
std::vector<Index> places_of(const std::vector<std::size_t>& tags, const std::vector<std::size_t>& sorted) {
  std::vector<Index> places(tags.size());
  std::ranges::transform(tags, places.begin(), [&](std::size_t tag) {
    return static_cast<Index>(std::ranges::lower_bound(sorted, tag) - sorted.begin());
  });
  return places;
}

void extract_nodes(const scene::Body& body, GmshMesh& result) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parametric;
  gmsh::model::mesh::getNodes(tags, coordinates, parametric);
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

void extract_elements(GmshMesh& result) {
  std::vector<std::size_t> node_tags;
  gmsh::model::mesh::getElementsByType(gmsh_type(result.mesh.element), result.element_tags, node_tags);
  const std::vector<Index> nodes = places_of(node_tags, result.node_tags);
  const std::vector<int>& order = element::reference(result.mesh.element).gmsh.nodes;
  for (auto first = nodes.begin(); first != nodes.end(); first += std::ssize(order)) {
    std::ranges::transform(order, std::back_inserter(result.mesh.elements), [&](int place) { return first[place]; });
  }
}

void extract_groups(GmshMesh& result) {
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups);
  for (const auto& [dimension, tag] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(dimension, tag, name);
    std::vector<std::size_t> node_tags;
    std::vector<double> coordinates;
    gmsh::model::mesh::getNodesForPhysicalGroup(dimension, tag, node_tags, coordinates);
    auto& nodes = result.mesh.groups[name.empty() ? std::to_string(tag) : name];
    std::ranges::copy(places_of(node_tags, result.node_tags), std::back_inserter(nodes));
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }
}

}  // namespace

void bring_to_order(const scene::Body& body) {
  if (body.element.kind == element::Kind::hex) {
    throw deck::DeckError(body.mesh_where, "meshes of hexahedra can't be read yet: use element: tet10");
  }
  require_tetrahedra(body);
  if (volume_element_types() != std::vector{gmsh_type(body.element)}) {
    gmsh::model::mesh::setOrder(element::reference(body.element).gmsh.order);
  }
}

GmshMesh extract(const scene::Body& body) {
  GmshMesh result;
  result.mesh.element = body.element;
  extract_nodes(body, result);
  extract_elements(result);
  extract_groups(result);
  return result;
}

}  // namespace idiophone::mesh
