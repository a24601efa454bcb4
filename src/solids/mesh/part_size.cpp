#include "idiophone/solids/mesh/part_size.hpp"

#include <algorithm>
#include <set>

#include "owners.hpp"
#include "part_builder.hpp"

namespace idiophone::mesh {

double work_of_element(element::Type type) {
  return static_cast<double>(work_of_node(type)) * element::node_count(type);
}

PartSize size_of(const Part& part) {
  PartSize size;
  for (const BodyPart& body : part.bodies) {
    const auto owned = static_cast<Index>(std::ranges::count(body.owned, 1));
    size.elements += owned;
    size.ghost_elements += static_cast<Index>(body.owned.size()) - owned;
    size.work += static_cast<double>(body.owned.size()) * work_of_element(body.element);
  }
  size.nodes = part.owned_nodes;
  size.ghost_nodes = static_cast<Index>(part.ghost_rank.size());
  size.triangles = static_cast<Index>(part.surface.size());
  size.neighbours = static_cast<Index>(std::set(part.ghost_rank.begin(), part.ghost_rank.end()).size());
  return size;
}

PartSize largest(const PartSize& a, const PartSize& b) {
  return {.elements = std::max(a.elements, b.elements),
          .ghost_elements = std::max(a.ghost_elements, b.ghost_elements),
          .nodes = std::max(a.nodes, b.nodes),
          .ghost_nodes = std::max(a.ghost_nodes, b.ghost_nodes),
          .triangles = std::max(a.triangles, b.triangles),
          .neighbours = std::max(a.neighbours, b.neighbours),
          .work = std::max(a.work, b.work)};
}

void for_each_part(const std::vector<Mesh>& meshes, int ranks, const std::function<void(const Part&)>& visit,
                   std::span<const std::vector<Index>> coupled) {
  PartBuilder builder(meshes, node_owners(meshes, ranks), coupled);
  for (int rank = 0; rank < ranks; ++rank) {
    visit(builder.build(rank));
  }
}

}  // namespace idiophone::mesh
