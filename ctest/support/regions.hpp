#pragma once
// Meshes with several materials for tests that need no mesher.

#include <algorithm>
#include <functional>
#include <numeric>

#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::support {

/// The mesh with its elements in regions, numbered region by region.
/// @param region_of  of the centre of an element's corners, m
inline mesh::Mesh with_regions(const mesh::Mesh& mesh, const std::function<Index(const Vector3& centre)>& region_of) {
  const std::vector<int>& corners = element::reference(mesh.element).corners;
  std::vector<Index> regions;
  for (Index element = 0; element < mesh.element_count(); ++element) {
    Vector3 centre = Vector3::Zero();
    for (const int corner : corners) {
      centre += mesh.nodes[mesh.element_nodes(element)[corner]] / static_cast<double>(corners.size());
    }
    regions.push_back(region_of(centre));
  }
  std::vector<Index> order(regions.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](Index element) { return regions[element]; });
  mesh::Mesh result = mesh;
  result.elements.clear();
  for (const Index element : order) {
    const auto nodes = mesh.element_nodes(element);
    result.elements.insert(result.elements.end(), nodes.begin(), nodes.end());
    result.regions.push_back(regions[element]);
  }
  return result;
}

}  // namespace idiophone::support
