#pragma once
// How the music of a sonic scene is read.

#include "idiophone/scene/sections.hpp"
#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"
#include "sonic_variables.hpp"

namespace idiophone::timbre {

/// What the numbers of music can be bound to by name.
struct MusicRules {
  deck::Choices<std::size_t> classes;  ///< of the scene, whose trees can compute numbers
  VariableRules variables;             ///< of the scene
};

/// music: {every, parts}
bool read(const deck::Node& node, deck::Mistakes& mistakes, Music& music, const MusicRules& rules);

}  // namespace idiophone::timbre
