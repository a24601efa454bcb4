#pragma once
// The shortest way around edges, one after the other.

#include <array>
#include <cstddef>
#include <span>

#include "idiophone/air/radiation/diffracting_edge.hpp"

namespace idiophone::radiation {

/// Sound is followed around up to this many edges in turn.
constexpr std::size_t most_in_turn = 3;

/// Where the shortest way from a source to a receiver that touches the line of each edge touches them, m. A point may
/// lie outside of its edge.
/// @param edges  1 to most_in_turn
[[nodiscard]] std::array<Vector3, most_in_turn> shortest_way(std::span<const DiffractingEdge> edges,
                                                             const Vector3& source, const Vector3& receiver);

}  // namespace idiophone::radiation
