#include "owners.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "idiophone/foundation/bounding_box.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "metis_partition.hpp"
#include "partition_vertices.hpp"

namespace idiophone::mesh {

namespace {

/// Adds an element, whose vertices are the last ones in the list.
void end_element(ElementLists& lists, std::size_t work) {
  lists.begins.push_back(static_cast<idx_t>(lists.nodes.size()));
  lists.work.push_back(work);
}

ElementLists element_lists(const std::vector<Mesh>& meshes, const Offsets& first, const PartitionVertices& vertices) {
  ElementLists lists{.begins = {0}, .nodes = {}, .weights = std::vector<idx_t>(vertices.count, 0), .work = {}};
  for (std::size_t body = 0; body < meshes.size(); ++body) {
    const Mesh& mesh = meshes[body];
    if (mesh.indivisible) {
      lists.nodes.push_back(vertices.of_node[first.nodes[body]]);
      lists.weights[lists.nodes.back()] += static_cast<idx_t>(mesh.nodes.size());  // modes are cheap
      end_element(lists, mesh.nodes.size());
      continue;
    }
    const idx_t work = work_of_node(mesh.element);
    std::vector<Index> here;
    for (Index element = 0; element < mesh.element_count(); ++element) {
      here.clear();
      for (const Index node : mesh.element_nodes(element)) {
        here.push_back(vertices.of_node[first.nodes[body] + node]);
        lists.weights[here.back()] += work;
      }
      const std::size_t nodes = here.size();
      if (vertices.count < first.nodes.back()) {
        keep_each_once(here);
      }
      lists.nodes.insert(lists.nodes.end(), here.begin(), here.end());
      end_element(lists, work * nodes);
    }
  }
  return lists;
}

Index nearest_node(const Mesh& mesh, const Vector3& place) {
  const auto distance = [&](const Vector3& node) { return (node - place).squaredNorm(); };
  return static_cast<Index>(std::ranges::min_element(mesh.nodes, {}, distance) - mesh.nodes.begin());
}

/// Joins bodies that are close to each other by a link between two of their nodes, so that METIS gives clusters of
/// bodies to a rank: they may touch, and contacts between ranks cost more.
void link_close_bodies(const std::vector<Mesh>& meshes, const Offsets& first, const PartitionVertices& vertices,
                       ElementLists& lists) {
  constexpr double close = 0.1;  // distance over the size of a body
  std::vector<Eigen::AlignedBox3d> boxes;
  std::ranges::transform(meshes, std::back_inserter(boxes), [](const Mesh& mesh) { return bounding_box(mesh.nodes); });
  for (std::size_t a = 0; a < meshes.size(); ++a) {
    for (std::size_t b = a + 1; b < meshes.size(); ++b) {
      const double size = std::min(boxes[a].sizes().maxCoeff(), boxes[b].sizes().maxCoeff());
      if (boxes[a].exteriorDistance(boxes[b]) < close * size) {
        lists.nodes.push_back(vertices.of_node[first.nodes[a] + nearest_node(meshes[a], boxes[b].center())]);
        lists.nodes.push_back(vertices.of_node[first.nodes[b] + nearest_node(meshes[b], boxes[a].center())]);
        end_element(lists, 0);
      }
    }
  }
}

/// METIS joins every vertex with all others of its elements; that many numbers have to fit its indices.
void require_that_metis_fits(const ElementLists& lists) {
  std::int64_t neighbours = 0;
  for (std::size_t element = 0; element + 1 < lists.begins.size(); ++element) {
    const std::int64_t vertices = lists.begins[element + 1] - lists.begins[element];
    neighbours += vertices * (vertices - 1);
  }
  if (neighbours > std::numeric_limits<idx_t>::max()) {
    throw std::runtime_error(
        fmt::format("the meshes are too large to be partitioned: METIS may need {} neighbours of nodes "
                    "and can number {}; run on one rank or use coarser meshes",
                    neighbours, std::numeric_limits<idx_t>::max()));
  }
}

bool leaves_one_empty(const std::vector<int>& owners, int ranks) {
  std::vector<char> used(ranks, 0);
  for (const int owner : owners) {
    used[owner] = 1;
  }
  return std::ranges::find(used, 0) != used.end();
}

std::vector<int> equal_chunks(Index vertices, int ranks) {
  std::vector<int> owners(vertices);
  for (std::int64_t vertex = 0; vertex < vertices; ++vertex) {
    owners[vertex] = static_cast<int>(vertex * ranks / vertices);
  }
  return owners;
}

/// Why there are less parts than nodes.
std::string_view reason_for_few(const std::vector<Mesh>& meshes) {
  if (std::ranges::any_of(meshes, [](const Mesh& mesh) { return mesh.beside.has_value(); })) {
    return ", since each modal body lies on one rank, and joined ones with large amplitudes lie all on one";
  }
  return std::ranges::any_of(meshes, &Mesh::indivisible) ? ", since each modal body lies on one rank" : "";
}

/// From the owners of vertices to those of nodes.
std::vector<int> of_nodes(const std::vector<int>& vertex_owners, const PartitionVertices& vertices) {
  std::vector<int> owners;
  std::ranges::transform(vertices.of_node, std::back_inserter(owners),
                         [&](Index vertex) { return vertex_owners[vertex]; });
  return owners;
}

}  // namespace

int work_of_node(element::Type type) {
  switch (type.kind) {
    case element::Kind::tet4:
      return 1;
    case element::Kind::tet10:
    case element::Kind::hex:
      return 2;
  }
  element::unknown_kind();
}

std::vector<int> node_owners(const std::vector<Mesh>& meshes, int ranks) {
  const Offsets first = offsets(meshes);
  const PartitionVertices vertices = partition_vertices(meshes);
  ElementLists lists = element_lists(meshes, first, vertices);
  const Index most = std::min(vertices.count, static_cast<Index>(lists.begins.size() - 1));
  if (ranks > most) {
    throw std::runtime_error(fmt::format("{} ranks are too many for {} nodes and {} elements{}: run on at most {}",
                                         ranks, first.nodes.back(), first.elements.back(), reason_for_few(meshes),
                                         most));
  }
  if (ranks == 1) {
    return equal_chunks(first.nodes.back(), 1);
  }
  link_close_bodies(meshes, first, vertices, lists);
  require_that_metis_fits(lists);
  std::vector<int> owners = metis_parts(std::move(lists), ranks);
  if (leaves_one_empty(owners, ranks)) {
    owners = equal_chunks(vertices.count, ranks);
  }
  return of_nodes(owners, vertices);
}

}  // namespace idiophone::mesh
