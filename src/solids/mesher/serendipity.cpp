#include "serendipity.hpp"

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>

namespace idiophone::mesher {

namespace {

using Tags = std::span<const std::uint64_t>;
using CornerTags = std::array<std::uint64_t, 4>;  ///< corners, ascending

constexpr int quadrilateral_of_8 = 16;  // gmsh's numbers of types
constexpr int quadrilateral_of_9 = 10;
constexpr int hexahedron_of_20 = 17;
constexpr int hexahedron_of_27 = 12;

/// Of a hexahedron of 20 nodes, the corners and edges of each face, in the order in which gmsh has their middles.
constexpr std::array<std::array<std::size_t, 8>, 6> faces = {{{0, 3, 2, 1, 9, 13, 11, 8},
                                                              {0, 1, 5, 4, 8, 12, 16, 10},
                                                              {0, 4, 7, 3, 10, 17, 15, 9},
                                                              {1, 2, 6, 5, 11, 14, 18, 12},
                                                              {2, 3, 7, 6, 13, 15, 19, 14},
                                                              {4, 5, 6, 7, 16, 18, 19, 17}}};

class Completion {
 public:
  explicit Completion(mesh::MeshingAnswer& answer) : answer_(answer) {
    for (std::size_t i = 0; i < answer.node_tags.size(); ++i) {
      places_[answer.node_tags[i]] = i;
      next_ = std::max(next_, answer.node_tags[i] + 1);
    }
  }

  /// The node within a face.
  /// @param nodes  its corners, then the middles of its edges
  std::uint64_t middle_of_face(Tags nodes) {
    const auto [known, is_new] = middles_.emplace(corners_of(nodes), next_);
    if (is_new) {
      add_node(nodes, 4, 0.5);
    }
    return known->second;
  }

  /// A node within a cell.
  std::uint64_t middle_of_cell(Tags nodes) {
    add_node(nodes, 8, 0.25);
    return answer_.node_tags.back();
  }

  /// The node within a face that some element has, or 0.
  [[nodiscard]] std::uint64_t known_middle(Tags nodes) const {
    const auto found = middles_.find(corners_of(nodes));
    return found == middles_.end() ? 0 : found->second;
  }

 private:
  static CornerTags corners_of(Tags nodes) {
    CornerTags corners{};
    std::ranges::copy(nodes.first(4), corners.begin());
    std::ranges::sort(corners);
    return corners;
  }

  /// Adds a node at -1/4 of each corner and so much of each middle of an edge: the shape functions in the middle.
  void add_node(Tags nodes, std::size_t corners, double share_of_middle) {
    for (std::size_t d = 0; d < 3; ++d) {
      double sum = 0.0;
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        sum += (a < corners ? -0.25 : share_of_middle) * answer_.coordinates[3 * places_.at(nodes[a]) + d];
      }
      answer_.coordinates.push_back(sum);
    }
    answer_.node_tags.push_back(next_++);
  }

  mesh::MeshingAnswer& answer_;
  std::map<std::uint64_t, std::size_t> places_;  ///< of nodes, by tag
  std::map<CornerTags, std::uint64_t> middles_;
  std::uint64_t next_ = 1;  ///< the first tag that no node has
};

void complete(Completion& completion, mesh::ElementBlock& block) {
  const bool is_solid = block.type == hexahedron_of_20;
  std::vector<std::uint64_t> all;
  for (std::size_t first = 0; first < block.node_tags.size(); first += static_cast<std::size_t>(block.width)) {
    const Tags nodes = Tags(block.node_tags).subspan(first, static_cast<std::size_t>(block.width));
    all.insert(all.end(), nodes.begin(), nodes.end());
    if (is_solid) {
      for (const auto& face : faces) {
        std::array<std::uint64_t, 8> around{};
        std::ranges::transform(face, around.begin(), [&](std::size_t place) { return nodes[place]; });
        all.push_back(completion.middle_of_face(around));
      }
      all.push_back(completion.middle_of_cell(nodes));
    } else {
      all.push_back(completion.middle_of_face(nodes));
    }
  }
  block.node_tags = std::move(all);
  block.type = is_solid ? hexahedron_of_27 : quadrilateral_of_9;
  block.width = is_solid ? 27 : 9;
  block.type_name = is_solid ? "Hexahedron 27" : "Quadrilateral 9";
}

/// Nodes that the completed elements of a physical group have within faces and cells.
std::vector<std::uint64_t> middles_of_group(int dimension, int group, const Completion& completion,
                                            const std::map<std::uint64_t, Tags>& hexahedra) {
  std::vector<int> entities;
  gmsh::model::getEntitiesForPhysicalGroup(dimension, group, entities);
  std::vector<std::uint64_t> result;
  for (const int entity : entities) {
    std::vector<std::size_t> tags, nodes;
    if (dimension == 2) {
      gmsh::model::mesh::getElementsByType(quadrilateral_of_8, tags, nodes, entity);
      for (std::size_t first = 0; first < nodes.size(); first += 8) {
        if (const std::uint64_t middle = completion.known_middle(Tags(nodes).subspan(first, 8)); middle != 0) {
          result.push_back(middle);
        }
      }
    } else if (dimension == 3) {
      gmsh::model::mesh::getElementsByType(hexahedron_of_20, tags, nodes, entity);
      for (const std::size_t tag : tags) {
        const Tags middles = hexahedra.at(tag).last(7);
        result.insert(result.end(), middles.begin(), middles.end());
      }
    }
  }
  return result;
}

}  // namespace

void complete_serendipity(mesh::MeshingAnswer& answer) {
  Completion completion(answer);
  std::map<std::uint64_t, Tags> hexahedra;  // by tag
  for (mesh::ElementBlock& block : answer.elements) {
    if (block.type != hexahedron_of_20 && block.type != quadrilateral_of_8) {
      continue;
    }
    complete(completion, block);
    const auto width = static_cast<std::size_t>(block.width);
    for (std::size_t i = 0; block.type == hexahedron_of_27 && i < block.element_tags.size(); ++i) {
      hexahedra[block.element_tags[i]] = Tags(block.node_tags).subspan(i * width, width);
    }
  }
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto middles = middles_of_group(groups[i].first, groups[i].second, completion, hexahedra);
    std::ranges::copy(middles, std::back_inserter(answer.groups[i].node_tags));
  }
}

}  // namespace idiophone::mesher
