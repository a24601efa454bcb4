#pragma once
// The element types. Other modules ask this module about a type, or switch over all kinds, without a default, so that
// the compiler names every place that a new kind needs. They never compare kinds.

#include <compare>
#include <cstdint>
#include <span>
#include <string_view>

namespace idiophone::element {

enum class Kind : std::uint8_t {
  tet4,   ///< tetrahedron with linear shape functions (the paper's)
  tet10,  ///< tetrahedron with quadratic shape functions, curved edges allowed
  hex,    ///< spectral hexahedron: Gauss-Lobatto-Legendre nodes and quadrature, curved faces allowed
};

inline constexpr int lowest_hex_order = 2;
inline constexpr int highest_hex_order = 8;

/// An element type. All elements of a body have the same one. Kinds that come in several orders keep them here.
struct Type {
  Kind kind = Kind::tet10;
  std::uint8_t plane = 0;      ///< of hex: order along xi_1 and xi_2, in the plane of a thin body
  std::uint8_t thickness = 0;  ///< of hex: order along xi_3, through the thickness of a thin body

  friend constexpr auto operator<=>(const Type&, const Type&) = default;
};

inline constexpr Type tet4{Kind::tet4};
inline constexpr Type tet10{Kind::tet10};

/// A spectral hexahedron.
/// @param plane, thickness  orders, lowest_hex_order to highest_hex_order
[[nodiscard]] constexpr Type hex(int plane, int thickness) {
  return {Kind::hex, static_cast<std::uint8_t>(plane), static_cast<std::uint8_t>(thickness)};
}

/// All types that a deck can name; of hex the one with the orders that it has unless the deck gives others.
[[nodiscard]] std::span<const Type> types();

/// As decks write it: "tet4", "tet10", "hex".
[[nodiscard]] std::string_view name(Type type);

/// Nodes of one element.
[[nodiscard]] int node_count(Type type);

/// Polynomial orders of the shape functions.
struct Orders {
  int plane;      ///< along the cell in the plane of a thin body
  int thickness;  ///< through the thickness of a thin body
};

[[nodiscard]] Orders orders(Type type);

/// Whether decks may choose the orders, as those of hexahedra.
[[nodiscard]] bool has_choice_of_orders(Type type);

/// The same type with other orders where they can be chosen; otherwise as it was.
[[nodiscard]] Type with_orders(Type type, Orders orders);

/// Lines of nodes through the thickness of an element, as a hexahedron has them: node a lies on line a % lines. Zero
/// where the nodes lie on no such lines: a body of such elements is not swept.
[[nodiscard]] int lines_through(Type type);

/// For the end of a switch over kinds, which no kind reaches.
/// @throws std::logic_error
[[noreturn]] void unknown_kind();

}  // namespace idiophone::element
