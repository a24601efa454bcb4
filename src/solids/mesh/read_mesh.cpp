#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "checks.hpp"
#include "hash.hpp"
#include "idiophone/foundation/bounding_box.hpp"
#include "idiophone/solids/mesh/faces.hpp"
#include "idiophone/solids/mesh/mesh_file.hpp"
#include "idiophone/solids/mesh/numbered_faces.hpp"
#include "ordered.hpp"
#include "put_in_place.hpp"
#include "spectral_hexahedra.hpp"
#include "straighten.hpp"
#include "values_of_views.hpp"

namespace idiophone::mesh {

namespace {

/// Asks about the unit of length of a body that is too small or too large to be a likely thing; otherwise empty. A
/// `scale` in the deck answers the question.
/// @param nodes  of its elements
std::string unit_question(const scene::Body& body, const std::vector<Vector3>& nodes) {
  constexpr double shortest = 2e-3, longest = 20.0;  // m
  const bool is_geo = body.mesh.extension() == ".geo";
  const double length = nodes.empty() ? 0.0 : bounding_box(nodes).sizes().maxCoeff();
  if (nodes.empty() || (length >= shortest && length <= longest) || (!is_geo && body.parameters.contains("scale"))) {
    return "";
  }
  if (is_geo) {
    return fmt::format("it is {:.4g} m long. Lengths in a .geo file are metres", length);
  }
  return fmt::format("it is {:.4g} m long. Is the file in another unit? `parameters: {{scale: {}}}` makes it {:.4g} m",
                     length, length > longest ? "0.001" : "1000", length > longest ? 1e-3 * length : 1e3 * length);
}

/// What density gives the mass that the file says; empty if it says none.
std::string mass_note(const scene::Body& body, const Mesh& mesh) {
  if (!body.file_mass) {
    return "";
  }
  double volume = 0.0;  // by the divergence theorem
  for (const auto& [a, b, c] : mesh.surface) {
    volume += mesh.nodes[a].dot(mesh.nodes[b].cross(mesh.nodes[c])) / 6.0;
  }
  return fmt::format("{} gives it the mass {:g} kg, which it has with the density {:.4g} kg/m3 of its material",
                     body.mesh.filename().string(), *body.file_mass, *body.file_mass / volume);
}

/// What the file has, checked, in its order and its axes.
GmshMesh read_file(const scene::Body& body, Answers& known) {
  GmshMesh loaded = load(body, known);
  if (loaded.made_here) {
    loaded.mesh.notes.push_back(straighten_distorted(loaded.mesh));
  }
  drop_unused_nodes(body, loaded);
  if (!loaded.is_stored) {
    loaded.mesh.notes.push_back(unit_question(body, loaded.mesh.nodes));
  }
  if (element::has_choice_of_orders(body.element) && !loaded.is_stored) {
    loaded = spectral_mesh(body, loaded);
  }
  check(body, loaded);
  return loaded;
}

/// @param mesh  in order, in the axes of its file: so its numbers do not depend on its place
Mesh finished(const scene::Body& body, const GmshMesh& loaded, Mesh mesh) {
  std::ranges::remove_copy(loaded.mesh.notes, std::back_inserter(mesh.notes), "");
  put_in_place(body, mesh.nodes);
  mesh.surface = exterior_triangles(mesh);
  if (const std::string note = mass_note(body, mesh); !note.empty()) {
    mesh.notes.push_back(note);
  }
  mesh.hash = hash_of(mesh);
  add_described_groups(mesh, body);
  mesh.indivisible = body.modal.has_value();
  return mesh;
}

Mesh read_mesh(const scene::Body& body, Answers& known) {
  const GmshMesh loaded = read_file(body, known);
  return finished(body, loaded, ordered(loaded.mesh).mesh);
}

/// The layers of a wall, and the physical groups of elements; a layer comes before a group of its name.
/// @param order  [elements] numbers before the elements were numbered along the curve
std::map<std::string, std::vector<Index>> element_groups(const scene::Body& body, const GmshMesh& loaded,
                                                         std::span<const Index> order) {
  std::map<std::string, std::vector<Index>> layers, groups;
  std::map<std::string, std::vector<std::size_t>> tags = loaded.element_groups;
  for (auto& [name, members] : tags) {
    std::ranges::sort(members);
  }
  for (std::size_t place = 0; place < order.size(); ++place) {
    if (body.has_layers()) {
      layers[body.regions[loaded.mesh.regions[order[place]]].name].push_back(static_cast<Index>(place));
    }
    for (const auto& [name, members] : tags) {
      if (std::ranges::binary_search(members, loaded.element_tags[order[place]])) {
        groups[name].push_back(static_cast<Index>(place));
      }
    }
  }
  layers.merge(groups);
  return layers;
}

}  // namespace

StoredMesh storable_mesh(const scene::Body& body) {
  scene::Body bare = body;
  bare.rotation = bare.position = Vector3::Zero();
  bare.fixed.clear();
  bare.driven.clear();
  Answers known;
  GmshMesh loaded = read_file(bare, known);
  std::vector<Index> regions = std::exchange(loaded.mesh.regions, {});
  OrderedMesh numbered = ordered(loaded.mesh);  // along the curve alone: other decks may have other regions
  loaded.mesh.regions = std::move(regions);
  StoredMesh stored{.body = body.name, .mesh = {}, .element_groups = element_groups(bare, loaded, numbered.elements)};
  stored.mesh = finished(bare, loaded, std::move(numbered.mesh));
  if (!loaded.views.empty()) {
    stored.mesh.notes.emplace_back("values of its nodes and elements (gmsh's views) are not in the mesh file");
  }
  return stored;
}

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
