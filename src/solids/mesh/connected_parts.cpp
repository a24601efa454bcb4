#include "connected_parts.hpp"

#include "idiophone/foundation/disjoint_sets.hpp"

namespace idiophone::mesh {

std::vector<Index> connected_parts(const Mesh& mesh) {
  DisjointSets connected(mesh.nodes.size());
  for (Index element = 0; element < mesh.element_count(); ++element) {
    const auto nodes = mesh.element_nodes(element);
    for (const Index node : nodes) {
      connected.join(node, nodes[0]);
    }
  }
  std::vector<Index> parts(mesh.nodes.size());
  Index count = 0;
  for (std::size_t node = 0; node < parts.size(); ++node) {  // the root of a part is its first node
    const Index root = connected.root(static_cast<Index>(node));
    parts[node] = root == static_cast<Index>(node) ? count++ : parts[root];
  }
  return parts;
}

}  // namespace idiophone::mesh
