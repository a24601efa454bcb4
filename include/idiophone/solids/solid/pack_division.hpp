#pragma once
// Which packs of a body can be computed while the motion of ghosts travels. The forces at a node are still added in
// ascending order of elements: a force that comes too early for this order is held until all others are there.

#include <cstddef>
#include <span>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/node_state.hpp"
#include "idiophone/solids/solid/pack_layout.hpp"

namespace idiophone::solid {

/// Forces of elements on nodes, each in a slot of its own until it is added.
class HeldForces {
 public:
  /// None are held.
  HeldForces() = default;

  /// @param needs_ghosts  [packs] packs that are computed after all others
  HeldForces(const mesh::BodyPart& part, const PackLayout& layout, const std::vector<bool>& needs_ghosts);

  /// Where the forces of a pack go: a slot, or `at_once` if a force is added to its node when it is computed. Null
  /// where all are added at once. [nodes of an element x lanes]
  [[nodiscard]] const Index* slots(std::size_t pack) const {
    return first_.empty() || first_[pack] == at_once ? nullptr : &slots_[static_cast<std::size_t>(first_[pack])];
  }
  static constexpr Index at_once = -1;

  [[nodiscard]] NodeForce& slot(Index number) { return forces_[number]; }

  /// Adds all held forces to their nodes. The slots have been filled since the last call.
  /// @param force  [local nodes] N
  void add(std::span<NodeForce> force) const;

  [[nodiscard]] std::size_t bytes() const {
    return forces_.size() * (sizeof(NodeForce) + sizeof(Index)) + (slots_.size() + first_.size()) * sizeof(Index);
  }

 private:
  std::vector<Index> first_;       ///< [packs] place in slots_, or at_once
  std::vector<Index> slots_;       ///< of packs with held forces
  std::vector<NodeForce> forces_;  ///< [slots] N
  std::vector<Index> nodes_;       ///< [slots] local numbers; the slots of a node are in ascending order of elements
};

/// The packs of a body in two groups.
struct PackDivision {
  /// All packs are inner ones.
  /// @param packs  their number
  [[nodiscard]] static PackDivision undivided(std::size_t packs) { return {{{0, packs}}, {}, {}}; }

  /// Packs that touch ghosts are apart.
  [[nodiscard]] static PackDivision by_ghosts(const mesh::BodyPart& part);

  std::vector<PackRange> inner;   ///< they need no ghost; ascending
  std::vector<PackRange> border;  ///< the others, which are computed later; ascending
  HeldForces held;
};

}  // namespace idiophone::solid
