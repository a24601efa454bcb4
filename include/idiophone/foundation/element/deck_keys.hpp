#pragma once
// Element types as decks write them.

#include <string>

#include "idiophone/foundation/element/type.hpp"

namespace idiophone::element {

/// The keys of a body that has the type: "element: tet10", or "element: hex, order: {plane: 4, thickness: 2}".
[[nodiscard]] std::string deck_keys(Type type);

}  // namespace idiophone::element
