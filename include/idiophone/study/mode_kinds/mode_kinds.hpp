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

/// Whether the kinds are those of a round body. Its modes "(m, n)" with m > 0 come in pairs of one frequency.
/// @param nodes  m
[[nodiscard]] bool is_round(std::span<const Vector3> nodes);

/// One of several bodies that joints tie together.
struct JoinedBody {
  std::string name;
  std::span<const Vector3> nodes;  ///< m
};

/// The kind of each mode of an assembly: by the form of all bodies together, where they are one piece. If that has no
/// name, and one body has more than 90 % of the kinetic energy of the mode, by the form of this body:
/// "lid: bending 1 along z".
/// @param is_one_piece    bodies are glued face to face
/// @param shapes          [modes][3 x nodes of all bodies] of the lowest modes, ascending
/// @param kinetic_shares  [modes][bodies] of the kinetic energy
/// @return [modes]; empty where a mode has no such name
[[nodiscard]] std::vector<std::string> kinds_of_assembly(std::span<const JoinedBody> bodies, bool is_one_piece,
                                                         const std::vector<std::vector<double>>& shapes,
                                                         std::span<const std::vector<double>> kinetic_shares);

}  // namespace idiophone::mode_kinds
