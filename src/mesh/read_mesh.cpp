#include <Eigen/Geometry>
#include <algorithm>

#include "checks.hpp"
#include "element_shape.hpp"
#include "faces.hpp"
#include "hash.hpp"
#include "space_filling_curve.hpp"

namespace idiophone::mesh {

namespace {

/// From "which one is at this place" to "at which place is this one".
std::vector<Index> inverse(const std::vector<Index>& order) {
  std::vector<Index> places(order.size());
  for (std::size_t place = 0; place < order.size(); ++place) {
    places[static_cast<std::size_t>(order[place])] = static_cast<Index>(place);
  }
  return places;
}

/// The same mesh with nodes and elements numbered along the curve.
Mesh ordered(const Mesh& mesh) {
  std::vector<Vector3> centres;
  centres.reserve(static_cast<std::size_t>(mesh.element_count()));
  for (Index element = 0; element < mesh.element_count(); ++element) {
    centres.push_back(centre_of(shape_of(mesh, element)));
  }
  const auto node_order = curve_order(mesh.nodes);
  const auto node_places = inverse(node_order);
  const auto renumbered = [&](Index node) { return node_places[static_cast<std::size_t>(node)]; };

  Mesh result;
  result.element = mesh.element;
  for (const Index node : node_order) {
    result.nodes.push_back(mesh.nodes[static_cast<std::size_t>(node)]);
  }
  for (const Index element : curve_order(centres)) {
    std::ranges::transform(mesh.element_nodes(element), std::back_inserter(result.elements), renumbered);
  }
  for (const auto& [name, nodes] : mesh.groups) {
    auto& group = result.groups[name];
    std::ranges::transform(nodes, std::back_inserter(group), renumbered);
    std::ranges::sort(group);
  }
  return result;
}

void put_in_place(const scene::Body& body, Mesh& mesh) {
  if (body.rotation.isZero(0.0) && body.position.isZero(0.0)) {
    return;  // the file's own bits
  }
  const Eigen::Matrix3d turn = body.turn();
  for (Vector3& node : mesh.nodes) {
    node = turn * node + body.position;
  }
}

}  // namespace

Mesh read_mesh(const scene::Body& body) {
  GmshMesh loaded = load(body);
  put_in_place(body, loaded.mesh);
  drop_unused_nodes(body, loaded);
  check(body, loaded);
  Mesh mesh = ordered(loaded.mesh);
  mesh.surface = exterior_triangles(mesh);
  mesh.hash = hash_of(mesh);
  return mesh;
}

}  // namespace idiophone::mesh
