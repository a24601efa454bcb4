#include "part_builder.hpp"

#include <algorithm>
#include <utility>

#include "idiophone/foundation/each_once.hpp"

namespace idiophone::mesh {

namespace {

/// Those of ascending global numbers that belong to a body.
/// @param first  [bodies + 1] first number of each body
std::span<const Index> of_body(std::span<const Index> numbers, const std::vector<Index>& first, std::size_t body) {
  const auto begin = std::ranges::lower_bound(numbers, first[body]);
  return {begin, std::lower_bound(begin, numbers.end(), first[body + 1])};
}

/// [bodies + 1] The first piece of each body, over all bodies.
std::vector<Index> first_pieces(const std::vector<Mesh>& meshes) {
  std::vector<Index> first = {0};
  for (const Mesh& mesh : meshes) {
    first.push_back(first.back() + mesh.piece_count());
  }
  return first;
}

}  // namespace

PartBuilder::PartBuilder(const std::vector<Mesh>& meshes, std::vector<int> owners,
                         std::span<const std::vector<Index>> coupled)
    : meshes_(meshes),
      coupled_(coupled),
      first_(offsets(meshes)),
      first_piece_(first_pieces(meshes)),
      owners_(std::move(owners)),
      ranks_(std::ranges::max(owners_) + 1),
      nodes_(ranks_, [this](auto visit) { for_each_node(visit); }),
      elements_(ranks_, [this](auto visit) { for_each_element(visit); }),
      triangles_(ranks_, [this](auto visit) { for_each_triangle(visit); }),
      owned_numbers_(owners_.size()),
      vertex_numbers_(owners_.size(), -1),
      local_(owners_.size(), -1) {
  for (int rank = 0; rank < ranks_; ++rank) {
    Index number = 0;
    for (const Index node : nodes_[rank]) {
      owned_numbers_[node] = number++;
    }
  }
  for (std::size_t body = 0; body < meshes.size(); ++body) {
    for (const auto& triangle : meshes[body].surface) {
      for (const Index node : triangle) {
        vertex_numbers_[first_.nodes[body] + node] = 0;
      }
    }
  }
  for (auto& number : vertex_numbers_) {
    if (number == 0) {
      number = vertices_++;
    }
  }
}

template <class Visit>
void PartBuilder::for_each_node(const Visit& visit) const {
  for (std::size_t node = 0; node < owners_.size(); ++node) {
    visit(owners_[node], static_cast<Index>(node));
  }
}

/// A rank takes every element that touches a node it owns.
template <class Visit>
void PartBuilder::for_each_element(const Visit& visit) const {
  std::vector<int> takers;
  for (std::size_t body = 0; body < meshes_.size(); ++body) {
    for (Index element = 0; element < meshes_[body].element_count(); ++element) {
      takers.clear();
      for (const Index node : meshes_[body].element_nodes(element)) {
        const int owner = owners_[first_.nodes[body] + node];
        if (std::ranges::find(takers, owner) == takers.end()) {
          takers.push_back(owner);
          visit(owner, first_.elements[body] + element);
        }
      }
    }
  }
}

/// A rank takes the triangles whose lowest node it owns.
template <class Visit>
void PartBuilder::for_each_triangle(const Visit& visit) const {
  for (std::size_t body = 0; body < meshes_.size(); ++body) {
    const auto& surface = meshes_[body].surface;
    for (std::size_t number = 0; number < surface.size(); ++number) {
      visit(owners_[first_.nodes[body] + std::ranges::min(surface[number])],
            first_.triangles[body] + static_cast<Index>(number));
    }
  }
}

Part PartBuilder::build(int rank) {
  Part part;
  part.global_nodes = first_.nodes.back();
  part.global_elements = first_.elements.back();
  part.global_triangles = first_.triangles.back();
  part.global_vertices = vertices_;
  part.first_piece = first_piece_;
  part.bodies.resize(meshes_.size());
  number_owned_nodes(rank, part);
  take_elements(rank, part);
  number_ghosts(rank, part);
  take_surface(rank, part);
  for (const Index node : part.node_ids) {
    local_[node] = -1;
  }
  return part;
}

void PartBuilder::number_owned_nodes(int rank, Part& part) {
  for (std::size_t body = 0; body < meshes_.size(); ++body) {
    part.bodies[body].owned_begin = static_cast<Index>(part.node_ids.size());
    for (const Index node : of_body(nodes_[rank], first_.nodes, body)) {
      local_[node] = owned_numbers_[node];
      add_node(node, part);
    }
    part.bodies[body].owned_end = static_cast<Index>(part.node_ids.size());
  }
  part.owned_nodes = static_cast<Index>(part.node_ids.size());
}

/// The elements' nodes keep their global numbers until the ghosts have theirs.
void PartBuilder::take_elements(int rank, Part& part) {
  for (std::size_t body = 0; body < meshes_.size(); ++body) {
    const Mesh& mesh = meshes_[body];
    const Index first_node = first_.nodes[body];
    const std::span<const Index> taken = of_body(elements_[rank], first_.elements, body);
    BodyPart& share = part.bodies[body];
    share.element = mesh.element;
    share.first_element = first_.elements[body];
    share.global_elements = mesh.element_count();
    share.element_ids.assign(taken.begin(), taken.end());
    share.elements.reserve(taken.size() * element::node_count(mesh.element));
    share.owned.reserve(taken.size());
    for (const Index element : taken) {
      const auto nodes = mesh.element_nodes(element - share.first_element);
      std::ranges::transform(nodes, std::back_inserter(share.elements), [&](Index node) { return first_node + node; });
      share.owned.push_back(owners_[first_node + std::ranges::min(nodes)] == rank ? 1 : 0);
      if (!mesh.regions.empty()) {
        share.regions.push_back(mesh.regions[element - share.first_element]);
      }
    }
  }
}

void PartBuilder::number_ghosts(int rank, Part& part) {
  std::vector<Index> ghosts;
  const auto add_others = [&](const std::vector<Index>& nodes) {
    std::ranges::copy_if(nodes, std::back_inserter(ghosts), [&](Index node) { return local_[node] < 0; });
  };
  for (const auto& share : part.bodies) {
    add_others(share.elements);
  }
  for (const auto& nodes : coupled_) {
    if (std::ranges::any_of(nodes, [&](Index node) { return owners_[node] == rank; })) {
      add_others(nodes);
    }
  }
  keep_each_once(ghosts);
  for (const Index node : ghosts) {
    local_[node] = static_cast<Index>(part.node_ids.size());
    add_node(node, part);
    part.ghost_rank.push_back(owners_[node]);
    part.ghost_index.push_back(owned_numbers_[node]);
  }
  for (auto& share : part.bodies) {
    std::ranges::transform(share.elements, share.elements.begin(), [&](Index node) { return local_[node]; });
  }
}

/// All nodes of the triangles are local: a triangle is part of an element, which is computed where any of its nodes is
/// owned.
void PartBuilder::take_surface(int rank, Part& part) {
  std::vector<Index> nodes;  // global
  for (std::size_t body = 0; body < meshes_.size(); ++body) {
    for (const Index number : of_body(triangles_[rank], first_.triangles, body)) {
      Triangle triangle = meshes_[body].surface[number - first_.triangles[body]];
      std::ranges::for_each(triangle, [&](Index& node) { node += first_.nodes[body]; });
      nodes.insert(nodes.end(), triangle.begin(), triangle.end());
      part.surface.push_back(triangle);
      part.triangle_ids.push_back(number);
      part.triangle_body.push_back(static_cast<Index>(body));
    }
  }
  keep_each_once(nodes);
  for (const Index node : nodes) {
    part.vertices.push_back(local_[node]);
    part.vertex_ids.push_back(vertex_numbers_[node]);
  }
  for (auto& triangle : part.surface) {
    for (Index& node : triangle) {
      node = static_cast<Index>(std::ranges::lower_bound(nodes, node) - nodes.begin());
    }
  }
}

void PartBuilder::add_node(Index node, Part& part) const {
  const auto body = static_cast<std::size_t>(std::ranges::upper_bound(first_.nodes, node) - first_.nodes.begin()) - 1;
  const Mesh& mesh = meshes_[body];
  const Index own = node - first_.nodes[body];
  part.node_ids.push_back(node);
  part.reference.push_back(mesh.nodes[own]);
  if (first_piece_.back() > 0) {
    part.pieces.push_back(mesh.pieces.empty() ? -1 : first_piece_[body] + mesh.pieces[own]);
  }
}

}  // namespace idiophone::mesh
