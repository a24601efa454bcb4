#pragma once
// The names that the modes of simple bodies have in textbooks (docs/use/modes.md, Kinds).

#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::mode_kinds {

/// The kind of each mode, by the form of the body, which is found from its nodes:
/// - bars: "bending 2 along z", "torsion 1", "longitudinal 1", numbered in the order of their frequencies;
/// - rectangular plates: "(m, n)", nodal lines across the first and the second side, or "in plane";
/// - round bodies: "(m, n)", nodal diameters and nodal circles, or "torsion 1", "in plane (m)".
/// - every body: "rigid motion 1" for a mode in which the body hardly bends, as on soft supports.
/// @param nodes   m
/// @param shapes  [modes][3 x nodes] of the lowest modes, ascending
/// @return [modes]; empty where a mode has no such name
[[nodiscard]] std::vector<std::string> kinds_of(std::span<const Vector3> nodes,
                                                const std::vector<std::vector<double>>& shapes);

}  // namespace idiophone::mode_kinds
