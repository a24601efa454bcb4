#include "groups.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <string>

#include "idiophone/foundation/each_once.hpp"

namespace idiophone::mesher {

namespace {

/// Of all elements of some points, curves, surfaces or volumes, ascending. gmsh's own list of them takes it ten times
/// as long.
std::vector<std::uint64_t> nodes_of(int dimension, const std::vector<int>& entities) {
  std::vector<std::uint64_t> nodes;
  for (const int entity : entities) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> element_tags, node_tags;
    gmsh::model::mesh::getElements(types, element_tags, node_tags, dimension, entity);
    for (const auto& block : node_tags) {
      nodes.insert(nodes.end(), block.begin(), block.end());
    }
  }
  keep_each_once(nodes);
  return nodes;
}

/// The tags of all elements of some surfaces or volumes.
std::vector<std::uint64_t> elements_of(int dimension, const std::vector<int>& entities) {
  std::vector<std::uint64_t> elements;
  for (const int entity : entities) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> element_tags, node_tags;
    gmsh::model::mesh::getElements(types, element_tags, node_tags, dimension, entity);
    for (const auto& block : element_tags) {
      elements.insert(elements.end(), block.begin(), block.end());
    }
  }
  return elements;
}

/// The nodes of the linear triangles of some surfaces; [3 x triangles].
std::vector<std::uint64_t> triangles_of(const std::vector<int>& surfaces) {
  constexpr int linear_triangle = 2;  // gmsh's number of the type
  std::vector<std::uint64_t> nodes;
  for (const int surface : surfaces) {
    std::vector<std::size_t> element_tags, node_tags;
    gmsh::model::mesh::getElementsByType(linear_triangle, element_tags, node_tags, surface);
    nodes.insert(nodes.end(), node_tags.begin(), node_tags.end());
  }
  return nodes;
}

}  // namespace

std::vector<mesh::GroupBlock> groups(int of_body) {
  gmsh::vectorpair found;
  gmsh::model::getPhysicalGroups(found);
  std::vector<mesh::GroupBlock> blocks;
  for (const auto& [dimension, tag] : found) {
    auto& block = blocks.emplace_back();
    block.tag = tag;
    gmsh::model::getPhysicalName(dimension, tag, block.name);
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, entities);
    block.node_tags = nodes_of(dimension, entities);
    if (dimension == 2) {
      block.triangles = triangles_of(entities);
    }
    if (dimension == of_body) {
      block.elements = elements_of(dimension, entities);
    }
  }
  return blocks;
}

std::vector<std::string> note_on_ungrouped(int of_body) {
  gmsh::vectorpair found;
  gmsh::model::getEntities(found, of_body);
  std::size_t with_elements = 0, ungrouped = 0;
  for (const auto& [dimension, tag] : found) {
    std::vector<int> types, physical;
    gmsh::model::mesh::getElementTypes(types, dimension, tag);
    gmsh::model::getPhysicalGroupsForEntity(dimension, tag, physical);
    with_elements += types.empty() ? 0 : 1;
    ungrouped += !types.empty() && physical.empty() ? 1 : 0;
  }
  if (ungrouped == 0 || ungrouped == with_elements) {
    return {};
  }
  return {
      fmt::format("{} in no physical group ({} of {}) belong to the body, too, though gmsh would not save them. "
                  "Delete what is not part of the body",
                  of_body == 3 ? "volumes" : "surfaces", ungrouped, with_elements)};
}

std::vector<mesh::GroupBlock> numbered_faces(int dimension) {
  gmsh::vectorpair found;
  if (dimension == 3) {
    gmsh::vectorpair volumes;
    gmsh::model::getEntities(volumes, 3);
    gmsh::model::getBoundary(volumes, found, false, false, false);
    keep_each_once(found);
  } else {
    gmsh::model::getEntities(found, 2);
  }
  std::vector<mesh::GroupBlock> blocks;
  for (const auto& [of_surface, tag] : found) {
    auto& block = blocks.emplace_back();
    block.tag = tag;
    block.name = "face_" + std::to_string(tag);
    block.node_tags = nodes_of(of_surface, {tag});
    block.triangles = triangles_of({tag});
  }
  return blocks;
}

}  // namespace idiophone::mesher
