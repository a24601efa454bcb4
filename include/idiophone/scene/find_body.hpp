#pragma once
// One body of a deck.

#include <span>
#include <string>

#include "idiophone/scene/body.hpp"

namespace idiophone::scene {

/// Index of a body of the deck. @param name  empty for the first
/// @throws std::runtime_error, with the names of the deck's bodies, if there is none of this name
[[nodiscard]] std::size_t find_body(std::span<const Body> bodies, const std::string& name);

}  // namespace idiophone::scene
