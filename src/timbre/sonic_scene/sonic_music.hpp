#pragma once
// How the music of a sonic scene is read.

#include "idiophone/scene/sections.hpp"
#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"

namespace idiophone::timbre {

struct MusicKeys {};

/// music: {every, parts}
bool read(const deck::Node& node, deck::Mistakes& mistakes, Music& music, const MusicKeys& rule);

}  // namespace idiophone::timbre
