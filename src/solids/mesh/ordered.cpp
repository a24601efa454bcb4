#include "ordered.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "element_shape.hpp"
#include "space_filling_curve.hpp"

namespace idiophone::mesh {

namespace {

/// From "which one is at this place" to "at which place is this one".
std::vector<Index> inverse(const std::vector<Index>& order) {
  std::vector<Index> places(order.size());
  for (std::size_t place = 0; place < order.size(); ++place) {
    places[order[place]] = static_cast<Index>(place);
  }
  return places;
}

/// Of the surface and of groups.
template <class Visit>
void for_each_triangle(Mesh& mesh, const Visit& visit) {
  std::ranges::for_each(mesh.surface, visit);
  for (auto& [name, triangles] : mesh.group_triangles) {
    std::ranges::for_each(triangles, visit);
  }
}

/// Along the curve, region by region.
std::vector<Index> element_order(const Mesh& mesh) {
  std::vector<Vector3> centres;
  centres.reserve(mesh.element_count());
  for (Index element = 0; element < mesh.element_count(); ++element) {
    centres.push_back(centre_of(shape_of(mesh, element)));
  }
  std::vector<Index> order = curve_order(centres);
  if (!mesh.regions.empty()) {
    std::ranges::stable_sort(order, {}, [&](Index element) { return mesh.regions[element]; });
  }
  return order;
}

}  // namespace

OrderedMesh ordered(const Mesh& mesh) {
  const std::vector<Index> node_order = curve_order(mesh.nodes), elements = element_order(mesh);
  const auto node_places = inverse(node_order);
  const auto renumbered = [&](Index node) { return node_places[node]; };

  Mesh result;
  result.element = mesh.element;
  for (const Index node : node_order) {
    result.nodes.push_back(mesh.nodes[node]);
  }
  for (const Index element : elements) {
    std::ranges::transform(mesh.element_nodes(element), std::back_inserter(result.elements), renumbered);
    if (!mesh.regions.empty()) {
      result.regions.push_back(mesh.regions[element]);
    }
  }
  for (const auto& [name, nodes] : mesh.groups) {
    auto& group = result.groups[name];
    std::ranges::transform(nodes, std::back_inserter(group), renumbered);
    std::ranges::sort(group);
  }
  result.surface = mesh.surface;
  result.group_triangles = mesh.group_triangles;
  for_each_triangle(result,
                    [&](Triangle& triangle) { std::ranges::transform(triangle, triangle.begin(), renumbered); });
  result.fracture_faces = mesh.fracture_faces;
  for (FractureFace& face : result.fracture_faces) {
    for (auto& side : face.nodes) {
      std::ranges::transform(side, side.begin(), renumbered);
    }
  }
  return {.mesh = std::move(result), .nodes = node_order, .elements = elements};
}

}  // namespace idiophone::mesh
