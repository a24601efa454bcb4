#include "owners.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include "idiophone/foundation/bounding_box.hpp"
#include "idiophone/foundation/disjoint_sets.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "metis_partition.hpp"

namespace idiophone::mesh {

namespace {

/// What METIS parts, its vertices: nodes, bodies that have to stay whole, and the fracture surfaces of a body, so that
/// one rank knows all about what breaks.
struct Vertices {
  std::vector<Index> of_node;  ///< [global nodes]
  Index count = 0;
};

/// The nodes of each column of hexahedra through the thickness, together.
DisjointSets columns_of(const Mesh& mesh) {
  DisjointSets columns(mesh.nodes.size());
  const auto lines = static_cast<std::size_t>(element::lines_through(mesh.element));
  for (Index element = 0; lines > 0 && element < mesh.element_count(); ++element) {
    const auto nodes = mesh.element_nodes(element);
    for (std::size_t a = lines; a < nodes.size(); ++a) {
      columns.join(nodes[a], nodes[a % lines]);
    }
  }
  return columns;
}

/// [nodes] 1 where a node is on a fracture surface, or in a column that has such a node: a rank has whole columns.
std::vector<char> on_fracture_faces(const Mesh& mesh) {
  std::vector<char> flags(mesh.nodes.size());
  if (mesh.fracture_faces.empty()) {
    return flags;
  }
  DisjointSets columns = columns_of(mesh);
  for (const FractureFace& face : mesh.fracture_faces) {
    for (const auto& side : face.nodes) {
      std::ranges::for_each(side, [&](Index node) { flags[columns.root(node)] = 1; });
    }
  }
  for (std::size_t node = 0; node < flags.size(); ++node) {
    flags[node] = flags[columns.root(static_cast<Index>(node))];
  }
  return flags;
}

Vertices number_vertices(const std::vector<Mesh>& meshes) {
  Vertices vertices;
  for (const Mesh& mesh : meshes) {
    const std::vector<char> in_fracture = on_fracture_faces(mesh);
    Index fracture = -1;  // the vertex of all nodes on fracture surfaces
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
      if (in_fracture[node] != 0 && fracture >= 0) {
        vertices.of_node.push_back(fracture);
        continue;
      }
      vertices.count += mesh.indivisible && node > 0 ? 0 : 1;
      vertices.of_node.push_back(vertices.count - 1);
      fracture = in_fracture[node] != 0 ? vertices.count - 1 : fracture;
    }
  }
  return vertices;
}

ElementLists element_lists(const std::vector<Mesh>& meshes, const Offsets& first, const Vertices& vertices) {
  ElementLists lists{.begins = {0}, .nodes = {}, .weights = std::vector<idx_t>(vertices.count, 0)};
  for (std::size_t body = 0; body < meshes.size(); ++body) {
    const Mesh& mesh = meshes[body];
    if (mesh.indivisible) {
      lists.nodes.push_back(vertices.of_node[first.nodes[body]]);
      lists.weights[lists.nodes.back()] = static_cast<idx_t>(mesh.nodes.size());  // modes are cheap
      lists.begins.push_back(static_cast<idx_t>(lists.nodes.size()));
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
      if (!mesh.fracture_faces.empty()) {
        keep_each_once(here);
      }
      lists.nodes.insert(lists.nodes.end(), here.begin(), here.end());
      lists.begins.push_back(static_cast<idx_t>(lists.nodes.size()));
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
void link_close_bodies(const std::vector<Mesh>& meshes, const Offsets& first, const Vertices& vertices,
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
        lists.begins.push_back(static_cast<idx_t>(lists.nodes.size()));
      }
    }
  }
}

/// METIS joins every node with all others of its elements; that many numbers have to fit its indices.
void require_that_metis_fits(const std::vector<Mesh>& meshes) {
  std::int64_t neighbours = 0;
  for (const auto& mesh : meshes) {
    neighbours += static_cast<std::int64_t>(mesh.elements.size()) * (element::node_count(mesh.element) - 1);
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

/// Gives all nodes of each line through the thickness of a hexahedron to the owner of one of them, as mass scaling
/// couples them (solid/added_mass.hpp).
void keep_columns_whole(const std::vector<Mesh>& meshes, const Offsets& first, std::vector<int>& owners) {
  for (std::size_t body = 0; body < meshes.size(); ++body) {
    const Mesh& mesh = meshes[body];
    const auto lines = static_cast<std::size_t>(element::lines_through(mesh.element));
    if (lines == 0) {
      continue;
    }
    for (Index element = 0; element < mesh.element_count(); ++element) {
      const auto nodes = mesh.element_nodes(element);
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        owners[first.nodes[body] + nodes[a]] = owners[first.nodes[body] + nodes[a % lines]];
      }
    }
  }
}

std::vector<int> equal_chunks(Index vertices, int ranks) {
  std::vector<int> owners(vertices);
  for (std::int64_t vertex = 0; vertex < vertices; ++vertex) {
    owners[vertex] = static_cast<int>(vertex * ranks / vertices);
  }
  return owners;
}

/// From the owners of vertices to those of nodes.
std::vector<int> expanded(const std::vector<int>& vertex_owners, const Vertices& vertices,
                          const std::vector<Mesh>& meshes, const Offsets& first) {
  std::vector<int> owners;
  std::ranges::transform(vertices.of_node, std::back_inserter(owners),
                         [&](Index vertex) { return vertex_owners[vertex]; });
  keep_columns_whole(meshes, first, owners);
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
  const Vertices vertices = number_vertices(meshes);
  ElementLists lists = element_lists(meshes, first, vertices);
  const Index most = std::min(vertices.count, static_cast<Index>(lists.begins.size() - 1));
  if (ranks > most) {
    const bool whole = std::ranges::any_of(meshes, &Mesh::indivisible);
    throw std::runtime_error(fmt::format("{} ranks are too many for {} nodes and {} elements{}: run on at most {}",
                                         ranks, first.nodes.back(), first.elements.back(),
                                         whole ? ", since each modal body lies on one rank" : "", most));
  }
  if (ranks == 1) {
    return equal_chunks(first.nodes.back(), 1);
  }
  require_that_metis_fits(meshes);
  link_close_bodies(meshes, first, vertices, lists);
  auto owners = expanded(metis_parts(std::move(lists), ranks), vertices, meshes, first);
  if (leaves_one_empty(owners, ranks)) {
    owners = expanded(equal_chunks(vertices.count, ranks), vertices, meshes, first);
  }
  if (leaves_one_empty(owners, ranks)) {
    throw std::runtime_error(fmt::format("{} ranks are too many for the bodies' hexahedra: use fewer", ranks));
  }
  return owners;
}

}  // namespace idiophone::mesh
