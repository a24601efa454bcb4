#pragma once
// Sound maps in the languages of other programs.

#include <span>
#include <string>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

/// A program in Faust, with one input, the force in newtons, and one output, the pressure in pascals. For a force that
/// is linear between samples it gives what sound_of() gives, without the delay to the listener.
/// @param participation  of a blow of 1 N (modal/blow.hpp), [modes] 1/sqrt(kg)
/// @param listener       index into SoundMap::listeners
/// @param place          of the blow, in words
[[nodiscard]] std::string faust_program(const sound_maps::SoundMap& map, std::span<const double> participation,
                                        std::size_t listener, const std::string& place);

/// A glTF 2.0 file, as JSON with its data in it: the surface as a mesh, and the modes as a modal model of the draft
/// extension KHR_audio_rigid_bodies (docs/use/sound_map.md).
[[nodiscard]] std::string gltf_file(const sound_maps::SoundMap& map);

}  // namespace idiophone::sound_maps
