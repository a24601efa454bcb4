#pragma once
// An ideal body as a section of a deck.

#include "idiophone/foundation/deck/section.hpp"
#include "idiophone/instruments/sound_maps/ideal_body.hpp"

namespace idiophone::sound_maps {

/// @param folder  of the deck, for the files that it names
bool read(const deck::Node& node, deck::Mistakes& mistakes, IdealBody& body, const deck::Folder& folder);

}  // namespace idiophone::sound_maps
