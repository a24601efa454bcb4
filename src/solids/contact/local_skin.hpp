#pragma once
// What a rank has of a body's skin.

#include <span>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/node_state.hpp"
#include "side.hpp"

namespace idiophone::contact {

/// A node of a skin that this rank has.
struct SkinNode {
  Index place;  ///< in the skin
  Index node;   ///< local number
};

struct LocalSkin {
  std::vector<SkinNode> owned;  ///< ascending
  std::vector<SkinNode> nodes;  ///< the owned ones and the ghosts of their cells, ascending
  std::vector<Index> cells;     ///< with an owned node, ascending
};

[[nodiscard]] LocalSkin find_local_skin(const Skin& skin, const mesh::Part& part);

/// Sets a node's position and velocity.
/// @param state  [local nodes]
inline void update(const SkinNode& node, std::span<const solid::NodeState> state, Side& side) {
  const solid::NodeState& now = state[node.node];
  side.position[node.place] = side.reference[node.place] + Eigen::Map<const Vector3>(now.displacement);
  side.velocity[node.place] = Eigen::Map<const Vector3>(now.velocity);
}

}  // namespace idiophone::contact
