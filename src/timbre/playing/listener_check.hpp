#pragma once
// Where the listener of a performance stands among its bodies.

#include <vector>

#include "cast.hpp"

namespace idiophone::timbre {

/// Warns of bodies that the listener hears badly or not at all: it comes near to a surface, nearer to a body than its
/// sound map knows, or behind the wall of an ideal body. Bodies are where they are at rest. The listeners of a sound
/// map were checked when it was made.
/// @param levels  [decks][bodies]
/// @throws deck::DeckError where the listener is inside a body
void check_listener(const Cast& cast, const std::vector<std::vector<ProxyLevels>>& levels, const score::Score& score);

}  // namespace idiophone::timbre
