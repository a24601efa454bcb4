#pragma once
// What a bow does, as decks and scores have it.

#include "idiophone/foundation/deck/section.hpp"
#include "idiophone/scene/bowing.hpp"

namespace idiophone::scene {

/// The keys direction, speed, load and friction of a bow.
/// @param longest  time of a point of speed and load, s
void read_bowing(deck::Section& section, Bowing& bowing, double longest);

}  // namespace idiophone::scene
