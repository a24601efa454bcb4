#pragma once
// An ideal body as a section of a deck.

#include "idiophone/foundation/deck/section.hpp"
#include "idiophone/instruments/sound_maps/ideal_body.hpp"

namespace idiophone::sound_maps {

bool read(const deck::Node& node, deck::Mistakes& mistakes, IdealBody& body);

}  // namespace idiophone::sound_maps
