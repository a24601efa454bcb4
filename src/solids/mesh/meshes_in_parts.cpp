#include "idiophone/solids/mesh/meshes_in_parts.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "checks.hpp"
#include "element_reader.hpp"
#include "hash_of_rows.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/solids/mesh/numbered_faces.hpp"
#include "load_mesh_file.hpp"
#include "mesh_file_paths.hpp"
#include "mesh_table_reader.hpp"
#include "neighbourhood.hpp"
#include "part_reader.hpp"
#include "put_in_place.hpp"

namespace idiophone::mesh {

namespace {

/// In the axes of the file.
/// @throws deck::DeckError as read_meshes()
Mesh read_outline(const scene::Body& body) {
  GmshMesh loaded;
  loaded.mesh = load_mesh_outline(body);
  if (!std::ranges::is_sorted(loaded.mesh.surface)) {
    refuse_unreadable(body, body.mesh.string() + ": its surface is not sorted: make it anew");
  }
  loaded.node_tags.resize(loaded.mesh.nodes.size());
  std::iota(loaded.node_tags.begin(), loaded.node_tags.end(), std::size_t{0});
  check_nodes(body, loaded);
  return std::move(loaded.mesh);
}

/// @throws deck::DeckError as read_meshes()
Index count_elements(const scene::Body& body) {
  Index count = 0;
  read_within_limit(
      body, [&] { count = MeshTables(body.mesh).rows(mesh_file::elements, element::node_count(body.element)); });
  return count;
}

/// From the file to the scene. Collective.
/// @param outline        on rank 0
/// @param rows           this rank's
/// @param element_count  of the body
void put_in_scene(const scene::Body& body, Mesh& outline, const ElementRows& rows, Index element_count,
                  MPI_Comm communicator) {
  parallel::on_root(communicator, [&] { put_in_place(body, outline.nodes); });
  if (is_moved(body) || !rows.region_counts.empty()) {
    outline.hash = hash_of_rows(outline, rows, element_count, communicator);
  }
  parallel::on_root(communicator, [&] { add_described_groups(outline, body); });
}

}  // namespace

bool fits_parts(const scene::Body& body) {
  return is_mesh_file(body.mesh);
}

std::optional<Index> stored_elements(const scene::Body& body) {
  try {
    return count_elements(body);
  } catch (const deck::DeckError&) {
    return std::nullopt;
  }
}

MeshShares read_shares(std::span<const scene::Body> bodies, MPI_Comm communicator) {
  MeshShares shares;
  Offsets& offsets = shares.offsets;
  parallel::on_root(communicator, [&] {
    std::ranges::transform(bodies, std::back_inserter(shares.outlines), read_outline);
    std::vector<Index> elements;
    std::ranges::transform(bodies, std::back_inserter(elements), count_elements);
    offsets = offsets_of(shares.outlines, elements);
  });
  for (auto* numbers : {&offsets.nodes, &offsets.elements, &offsets.triangles}) {
    parallel::broadcast(*numbers, communicator);
  }
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    Mesh none;
    Mesh& outline = shares.outlines.empty() ? none : shares.outlines[body];
    const Index elements = offsets.elements[body + 1] - offsets.elements[body];
    shares.rows.push_back(read_element_rows(bodies[body], outline, elements,
                                            offsets.nodes[body + 1] - offsets.nodes[body], communicator));
    put_in_scene(bodies[body], outline, shares.rows.back(), elements, communicator);
  }
  return shares;
}

void give_root_elements(std::span<const scene::Body> bodies, MeshShares& meshes, std::vector<std::vector<Index>> nodes,
                        MPI_Comm communicator) {
  nodes.resize(bodies.size());
  Mesh none;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    give_root_elements(meshes.rows[body], bodies[body], std::move(nodes[body]),
                       meshes.outlines.empty() ? none : meshes.outlines[body], communicator);
  }
}

ReadPart read_part(std::span<const scene::Body> bodies, MeshShares& meshes, std::span<const std::vector<Index>> coupled,
                   MPI_Comm communicator) {
  return PartReader(bodies, meshes.outlines, meshes.offsets, meshes.rows, coupled, communicator).read();
}

void for_each_part_in_rows(std::span<const scene::Body> bodies, const std::vector<Mesh>& outlines,
                           const Offsets& offsets, std::vector<ElementRows>& rows,
                           std::span<const std::vector<Index>> coupled, int ranks,
                           const std::function<void(const Part&)>& visit, MPI_Comm communicator) {
  PartReader(bodies, outlines, offsets, rows, coupled, communicator).for_each_part(ranks, visit);
}

}  // namespace idiophone::mesh
