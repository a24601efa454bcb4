#include "idiophone/solids/contact/skin.hpp"

#include <algorithm>
#include <limits>

#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "tetrahedron.hpp"

namespace idiophone::contact {

namespace {

mesh::Triangle sorted(mesh::Triangle triangle) {
  std::ranges::sort(triangle);
  return triangle;
}

std::array<Vector3, 4> places(const mesh::Mesh& mesh, const std::array<Index, 4>& cell) {
  std::array<Vector3, 4> corners;
  std::ranges::transform(cell, corners.begin(), [&](Index node) { return mesh.nodes[node]; });
  return corners;
}

}  // namespace

Skin make_skin(const mesh::Mesh& mesh, Index first_node) {
  const std::vector<double> areas = mesh::nodal_areas(mesh.outer_surface(), mesh.nodes);
  std::vector<mesh::Triangle> surface;
  std::ranges::transform(mesh.outer_surface(), std::back_inserter(surface), sorted);
  std::ranges::sort(surface);
  const auto on_surface = [&](Index node) { return areas[node] > 0; };

  Skin skin;
  skin.thinnest = std::numeric_limits<double>::infinity();
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(e);
    for (const auto& corners : element::reference(mesh.element).straight_tetrahedra) {
      std::array<Index, 4> cell;
      std::ranges::transform(corners, cell.begin(), [&](int corner) { return nodes[corner]; });
      if (std::ranges::none_of(cell, on_surface)) {
        continue;
      }
      const Tetrahedron shape(places(mesh, cell));
      auto& exterior = skin.exterior.emplace_back();
      for (std::size_t f = 0; f < 4; ++f) {
        const mesh::Triangle face = sorted({cell[(f + 1) % 4], cell[(f + 2) % 4], cell[(f + 3) % 4]});
        exterior.at(f) = std::ranges::binary_search(surface, face) ? 1 : 0;
        skin.thinnest = std::min(skin.thinnest, 1 / shape.gradients.at(f).norm());
      }
      skin.cells.push_back(cell);
      skin.nodes.insert(skin.nodes.end(), cell.begin(), cell.end());
    }
  }
  keep_each_once(skin.nodes);
  for (auto& cell : skin.cells) {
    for (Index& node : cell) {
      node = static_cast<Index>(std::ranges::lower_bound(skin.nodes, node) - skin.nodes.begin());
    }
  }
  for (Index& node : skin.nodes) {
    skin.areas.push_back(areas[node]);
    node += first_node;
  }
  return skin;
}

Skin broadcast(Skin skin, MPI_Comm communicator) {
  parallel::broadcast(skin.nodes, communicator);
  parallel::broadcast(skin.areas, communicator);
  parallel::broadcast(skin.cells, communicator);
  parallel::broadcast(skin.exterior, communicator);
  parallel::broadcast(skin.thinnest, communicator);
  return skin;
}

}  // namespace idiophone::contact
