#pragma once
// The names of crystal symmetries in decks.

#include "idiophone/foundation/deck/values.hpp"
#include "idiophone/scene/anisotropy.hpp"

namespace idiophone::scene {

/// "cubic", "hexagonal", ...
[[nodiscard]] const deck::Choices<Symmetry>& symmetries();

}  // namespace idiophone::scene
