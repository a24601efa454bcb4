#pragma once
// How the music of a sonic scene is read.

#include "idiophone/scene/sonic_scene.hpp"
#include "sections.hpp"

namespace idiophone::scene {

struct MusicKeys {};

/// music: {every, parts}
bool read(const Node& node, Mistakes& mistakes, Music& music, const MusicKeys& rule);

}  // namespace idiophone::scene
