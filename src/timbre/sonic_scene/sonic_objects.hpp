#pragma once
// How the places of sounds and objects, objects, and directivities of sounds are read.

#include "idiophone/scene/sections.hpp"
#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"

namespace idiophone::timbre {

/// The keys at, path and body: one of them, or none.
/// @param what  "a sound" or "an object", for the message
void read_source_place(deck::Section& section, SonicPlace& place, const deck::Folder& folder, const std::string& what);

/// directivity: {pattern or bands, axis}
bool read(const deck::Node& node, deck::Mistakes& mistakes, Directivity& directivity);

/// objects.NAME: {size or mesh, parameters and meshing, rotation, a place, surface_density, absorption}
bool read(const deck::Node& node, deck::Mistakes& mistakes, SonicObject& object, const deck::Folder& folder);

}  // namespace idiophone::timbre
