#include "idiophone/solids/mesh/meshes_in_parts.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "checks.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/solids/mesh/numbered_faces.hpp"
#include "load_mesh_file.hpp"
#include "mesh_file_paths.hpp"
#include "mesh_table_reader.hpp"
#include "part_reader.hpp"

namespace idiophone::mesh {

namespace {

/// @throws deck::DeckError as read_meshes()
Mesh read_outline(const scene::Body& body) {
  GmshMesh loaded;
  loaded.mesh = load_mesh_outline(body);
  if (!std::ranges::is_sorted(loaded.mesh.surface)) {
    throw deck::DeckError(body.mesh_where, unreadable(body, "its surface is not sorted: make it anew"));
  }
  loaded.node_tags.resize(loaded.mesh.nodes.size());
  std::iota(loaded.node_tags.begin(), loaded.node_tags.end(), std::size_t{0});
  check_nodes(body, loaded);
  add_described_groups(loaded.mesh, body);
  return std::move(loaded.mesh);
}

Index element_count(const scene::Body& body) {
  return MeshTables(body.mesh).rows(mesh_file::elements, element::node_count(body.element));
}

}  // namespace

bool fits_parts(const scene::Body& body) {
  return is_mesh_file(body.mesh) && !element::has_choice_of_orders(body.element) && body.regions.empty() &&
         body.rotation.isZero(0.0) && body.position.isZero(0.0);
}

std::optional<Index> stored_elements(const scene::Body& body) {
  try {
    return element_count(body);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

Outlines read_outlines(std::span<const scene::Body> bodies, MPI_Comm communicator) {
  Outlines outlines;
  parallel::on_root(communicator, [&] {
    std::transform(bodies.begin(), bodies.end(), std::back_inserter(outlines.meshes), read_outline);
    std::vector<Index> elements;
    std::transform(bodies.begin(), bodies.end(), std::back_inserter(elements), [](const scene::Body& body) {
      const std::optional<Index> count = stored_elements(body);
      if (!count) {
        throw deck::DeckError(body.mesh_where, unreadable(body, "its elements can't be read"));
      }
      return *count;
    });
    outlines.offsets = offsets_of(outlines.meshes, elements);
  });
  for (auto* numbers : {&outlines.offsets.nodes, &outlines.offsets.elements, &outlines.offsets.triangles}) {
    parallel::broadcast(*numbers, communicator);
  }
  return outlines;
}

ReadPart read_part(std::span<const scene::Body> bodies, const Outlines& outlines,
                   std::span<const std::vector<Index>> coupled, MPI_Comm communicator) {
  return PartReader(bodies, outlines, coupled, communicator).read();
}

}  // namespace idiophone::mesh
