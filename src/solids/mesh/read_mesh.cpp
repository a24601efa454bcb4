#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "checks.hpp"
#include "element_shape.hpp"
#include "faces.hpp"
#include "hash.hpp"
#include "space_filling_curve.hpp"
#include "spectral_hexahedra.hpp"
#include "straighten.hpp"
#include "values_of_views.hpp"

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

/// A mesh numbered along the curve, and where its nodes and elements were before.
struct OrderedMesh {
  Mesh mesh;
  std::vector<Index> nodes, elements;
};

OrderedMesh ordered(const Mesh& mesh) {
  std::vector<Vector3> centres;
  centres.reserve(mesh.element_count());
  for (Index element = 0; element < mesh.element_count(); ++element) {
    centres.push_back(centre_of(shape_of(mesh, element)));
  }
  const std::vector<Index> node_order = curve_order(mesh.nodes), element_order = curve_order(centres);
  const auto node_places = inverse(node_order);
  const auto renumbered = [&](Index node) { return node_places[node]; };

  Mesh result;
  result.element = mesh.element;
  for (const Index node : node_order) {
    result.nodes.push_back(mesh.nodes[node]);
  }
  for (const Index element : element_order) {
    std::ranges::transform(mesh.element_nodes(element), std::back_inserter(result.elements), renumbered);
  }
  for (const auto& [name, nodes] : mesh.groups) {
    auto& group = result.groups[name];
    std::ranges::transform(nodes, std::back_inserter(group), renumbered);
    std::ranges::sort(group);
  }
  return {.mesh = std::move(result), .nodes = node_order, .elements = element_order};
}

/// Asks about the unit of length of a part that is too small or too large to be a likely thing; otherwise empty.
std::string unit_question(const std::vector<Vector3>& nodes) {
  constexpr double shortest = 2e-3, longest = 20.0;  // m
  Eigen::AlignedBox3d box;
  for (const Vector3& node : nodes) {
    box.extend(node);
  }
  const double length = nodes.empty() ? 0.0 : box.sizes().maxCoeff();
  if (nodes.empty() || (length >= shortest && length <= longest)) {
    return "";
  }
  return fmt::format("it is {:.4g} m long. Is the file in another unit? `parameters: {{scale: {}}}` makes it {:.4g} m",
                     length, length > longest ? "0.001" : "1000", length > longest ? 1e-3 * length : 1e3 * length);
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

/// What the file has, checked, in its order.
GmshMesh read_file(const scene::Body& body, Answers& known) {
  GmshMesh loaded = load(body, known);
  if (loaded.made_here) {
    loaded.mesh.notes.push_back(straighten_distorted(loaded.mesh));
  }
  if (loaded.made_here && body.mesh.extension() != ".geo") {
    loaded.mesh.notes.push_back(unit_question(loaded.mesh.nodes));
  }
  put_in_place(body, loaded.mesh);
  drop_unused_nodes(body, loaded);
  if (element::has_choice_of_orders(body.element)) {
    loaded = spectral_mesh(body, loaded);
  }
  check(body, loaded);
  return loaded;
}

/// @param mesh  in order
Mesh finished(const scene::Body& body, const GmshMesh& loaded, Mesh mesh) {
  std::ranges::remove_copy(loaded.mesh.notes, std::back_inserter(mesh.notes), "");
  mesh.surface = exterior_triangles(mesh);
  mesh.hash = hash_of(mesh);
  mesh.indivisible = body.modal.has_value();
  return mesh;
}

Mesh read_mesh(const scene::Body& body, Answers& known) {
  const GmshMesh loaded = read_file(body, known);
  return finished(body, loaded, ordered(loaded.mesh).mesh);
}

}  // namespace

ValuedMesh read_mesh_with_values(const scene::Body& body) {
  Answers known;
  const GmshMesh loaded = read_file(body, known);
  OrderedMesh numbered = ordered(loaded.mesh);
  std::vector<MeshValues> values = values_of_views(body, loaded, numbered.nodes, numbered.elements);
  return {.mesh = finished(body, loaded, std::move(numbered.mesh)), .values = std::move(values)};
}

Mesh read_mesh(const scene::Body& body) {
  Answers known;
  return read_mesh(body, known);
}

std::vector<Mesh> read_meshes(std::span<const scene::Body> bodies) {
  Answers known;
  std::vector<Mesh> meshes;
  for (const scene::Body& body : bodies) {
    meshes.push_back(read_mesh(body, known));
  }
  return meshes;
}

}  // namespace idiophone::mesh
