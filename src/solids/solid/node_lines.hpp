#pragma once
// Between the lines of memory that nodes have (node_state.hpp) and packs of elements.

#include <cstddef>
#include <cstring>

#include "idiophone/foundation/types.hpp"
#include "idiophone/solids/solid/node_state.hpp"
#include "idiophone/solids/solid/pack.hpp"
#include "idiophone/solids/solid/pack_division.hpp"

namespace idiophone::solid {

/// The motion of one node of each element of a pack: displacement 0 1 2, velocity 3 4 5.
inline void gather_node(const NodeState* state, const Index (&nodes)[lanes], Pack (&rows)[line_length]) {
  static_assert(sizeof(NodeState) == line_length * sizeof(double));
  read_lines([&](int lane) { return state[nodes[lane]].displacement; }, rows);
}

/// What a NodeForce holds.
using ForceLine = double __attribute__((vector_size(4 * sizeof(double))));

/// The forces on two nodes of each element of a pack.
inline void gather_forces(const NodeForce* force, const Index (&first)[lanes], const Index (&second)[lanes],
                          Pack (&on_first)[3], Pack (&on_second)[3]) {
  alignas(Pack) double lines[lanes][line_length];
  for (int lane = 0; lane < lanes; ++lane) {
    std::memcpy(lines[lane], force[first[lane]].component, sizeof(ForceLine));
    std::memcpy(lines[lane] + 4, force[second[lane]].component, sizeof(ForceLine));
  }
  Pack rows[line_length];
  read_lines([&](int lane) { return lines[lane]; }, rows);
  for (int i = 0; i < 3; ++i) {
    on_first[i] = rows[i];
    on_second[i] = rows[4 + i];
  }
}

/// Turns the forces on two nodes of each element of a pack into the lines of each element, [lane][a] and [lane][a + 1].
template <std::size_t width>
inline void put_lines(const Pack (&first)[3], const Pack (&second)[3], ForceLine (&lines)[lanes][width],
                      std::size_t a) {
  // The fourth row means nothing. (With a row of zeros there, GCC 12 makes wrong code of the transpose.)
  const Pack rows[line_length] = {first[0],  first[1],  first[2],  first[2],  //
                                  second[0], second[1], second[2], second[2]};
  write_lines(rows, [&](int lane) { return reinterpret_cast<double*>(&lines[lane][a]); });
}

/// Adds a line to the force on a node.
inline void add_line(const ForceLine& line, NodeForce& force) {
  auto* component = static_cast<double*>(__builtin_assume_aligned(force.component, sizeof(ForceLine)));
  ForceLine sum;
  std::memcpy(&sum, component, sizeof(ForceLine));
  sum += line;
  std::memcpy(component, &sum, sizeof(ForceLine));
}

/// Adds the forces of a pack to its nodes: element after element, so that a node's sum has the same order on any rank.
/// @param lines     [lane][a]
/// @param count     nodes of an element
/// @param held      takes the forces that have to wait for others; null if none has to
/// @param force_on  force_on(a, lane) is the force on a node
template <std::size_t width, class ForceOn>
inline void scatter_lines(const ForceLine (&lines)[lanes][width], std::size_t count, int filled, std::size_t pack,
                          HeldForces* held, const ForceOn& force_on) {
  const Index* slots = held == nullptr ? nullptr : held->slots(pack);
  for (int lane = 0; lane < filled; ++lane) {
    if (slots == nullptr) {
      for (std::size_t a = 0; a < count; ++a) {
        add_line(lines[lane][a], force_on(a, lane));
      }
      continue;
    }
    for (std::size_t a = 0; a < count; ++a) {
      const Index slot = slots[a * lanes + static_cast<std::size_t>(lane)];
      if (slot == HeldForces::at_once) {
        add_line(lines[lane][a], force_on(a, lane));
      } else {
        std::memcpy(held->slot(slot).component, &lines[lane][a], sizeof(ForceLine));
      }
    }
  }
}

}  // namespace idiophone::solid
