#pragma once
// The keys of a deck that say what bounds an ideal body.

#include "idiophone/foundation/deck/section.hpp"
#include "idiophone/instruments/sound_maps/ideal_body.hpp"

namespace idiophone::sound_maps {

/// Length and width.
void read_sides(deck::Section& section, IdealBody& body);

/// Outline, holes and size of the elements of a membrane or plate, and the edges of a plate. A plate with length and
/// width is a rectangle from the origin on.
void read_outline(deck::Section& section, IdealBody& body);

}  // namespace idiophone::sound_maps
