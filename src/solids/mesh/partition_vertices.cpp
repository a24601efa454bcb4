#include "partition_vertices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "compressed_rows.hpp"
#include "idiophone/foundation/disjoint_sets.hpp"

namespace idiophone::mesh {

namespace {

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

/// [nodes] 1 where a node is on a fracture surface, or in a column that has such a node.
std::vector<char> on_fracture_surfaces(const Mesh& mesh) {
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

void join_all(const std::vector<char>& flags, DisjointSets& sets) {
  const auto first = std::ranges::find(flags, 1) - flags.begin();
  for (std::size_t node = 0; node < flags.size(); ++node) {
    if (flags[node] != 0) {
      sets.join(static_cast<Index>(node), static_cast<Index>(first));
    }
  }
}

/// @param apart  [nodes] 1 for those that are left alone
void join_nodes_of_same_elements(const Mesh& mesh, const std::vector<char>& apart, DisjointSets& sets) {
  const CompressedRows elements_of(static_cast<Index>(mesh.nodes.size()), [&mesh](const auto& visit) {
    for (Index element = 0; element < mesh.element_count(); ++element) {
      for (const Index node : mesh.element_nodes(element)) {
        visit(node, element);
      }
    }
  });
  std::vector<Index> here;
  for (Index element = 0; element < mesh.element_count(); ++element) {
    here.clear();
    std::ranges::copy_if(mesh.element_nodes(element), std::back_inserter(here),
                         [&](Index node) { return apart[node] == 0; });
    std::ranges::sort(
        here, [&](Index a, Index b) { return std::ranges::lexicographical_compare(elements_of[a], elements_of[b]); });
    for (std::size_t i = 1; i < here.size(); ++i) {
      if (std::ranges::equal(elements_of[here[i - 1]], elements_of[here[i]])) {
        sets.join(here[i - 1], here[i]);
      }
    }
  }
}

DisjointSets nodes_owned_together(const Mesh& mesh) {
  DisjointSets sets(mesh.nodes.size());
  if (mesh.indivisible) {
    join_all(std::vector<char>(mesh.nodes.size(), 1), sets);
    return sets;
  }
  const std::vector<char> breaking = on_fracture_surfaces(mesh);
  join_all(breaking, sets);
  if (element::lines_through(mesh.element) > 0) {  // hexahedra
    join_nodes_of_same_elements(mesh, breaking, sets);
  }
  return sets;
}

void require_earlier(std::size_t other, std::size_t body) {
  if (other >= body) {
    throw std::invalid_argument(
        fmt::format("the mesh of body {} of these is to be beside that of body {}, which has "
                    "to be an earlier one of them: take Mesh::beside from copies",
                    body, other));
  }
}

}  // namespace

PartitionVertices partition_vertices(const std::vector<Mesh>& meshes) {
  PartitionVertices vertices;
  std::vector<std::size_t> first_nodes;
  for (const Mesh& mesh : meshes) {
    first_nodes.push_back(vertices.of_node.size());
    if (mesh.beside) {
      require_earlier(*mesh.beside, first_nodes.size() - 1);
      vertices.of_node.resize(vertices.of_node.size() + mesh.nodes.size(), vertices.of_node[first_nodes[*mesh.beside]]);
      continue;
    }
    DisjointSets sets = nodes_owned_together(mesh);
    const std::size_t first = first_nodes.back();
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
      const auto root = static_cast<std::size_t>(sets.root(static_cast<Index>(node)));
      vertices.of_node.push_back(root == node ? vertices.count++ : vertices.of_node[first + root]);
    }
  }
  return vertices;
}

}  // namespace idiophone::mesh
