#pragma once
// Which edges a way can go around one after the other.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/air/radiation/bend.hpp"

namespace idiophone::radiation {

/// Edges in turn, by their numbers.
struct EdgeSequence {
  std::array<std::size_t, most_in_turn> edges = {};
  std::array<bool, most_in_turn> turned = {};  ///< whether the way comes from the side of an edge's second face
  std::size_t count = 1;
  std::array<bool, most_in_turn - 1> over_face = {};  ///< as in EdgesInTurn

  [[nodiscard]] EdgesInTurn placed(std::span<const DiffractingEdge> all) const;
};

/// All sequences of up to most_in_turn edges that a stretched string can go around: at each edge it bends towards the
/// solid. Whether something is in its way is not considered. Neighbours among three edges are parallel within 30
/// degrees: ways around skew ones pass near corners, where edges are too short for find_bend().
/// @param objects  [edges] which object each belongs to; ways go over faces of one object only
[[nodiscard]] std::vector<EdgeSequence> find_edge_sequences(std::span<const DiffractingEdge> edges,
                                                            std::span<const std::size_t> objects);

}  // namespace idiophone::radiation
