#pragma once
// The element types. Other rooms ask this room about a type; a switch over kinds has no default, so that the compiler
// names every place that a new kind needs.

#include <cstdint>
#include <span>
#include <string_view>

namespace idiophone::element {

enum class Kind : std::uint8_t {
  tet4,   ///< tetrahedron with linear shape functions (the paper's)
  tet10,  ///< tetrahedron with quadratic shape functions, curved edges allowed
};

/// An element type. All elements of a body have the same one. Kinds that come in several orders keep them here.
struct Type {
  Kind kind = Kind::tet10;

  friend constexpr bool operator==(const Type&, const Type&) = default;
};

inline constexpr Type tet4{Kind::tet4};
inline constexpr Type tet10{Kind::tet10};

/// All types that a deck can name.
[[nodiscard]] std::span<const Type> types();

/// As decks write it: "tet4", "tet10".
[[nodiscard]] std::string_view name(Type type);

/// Nodes of one element.
[[nodiscard]] int node_count(Type type);

/// The type of tetrahedra with so many nodes.
/// @throws std::invalid_argument if there is none
[[nodiscard]] Type tetrahedron_with(int nodes);

/// For the end of a switch over kinds, which no kind reaches.
/// @throws std::logic_error
[[noreturn]] void unknown_kind();

}  // namespace idiophone::element
