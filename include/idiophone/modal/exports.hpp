#pragma once
// Sound maps in the languages of other programs.

#include <string>

#include "idiophone/store/sound_map.hpp"

namespace idiophone::modal {

/// Where a body is struck and who hears it.
struct Strike {
  Vector3 at = Vector3::Zero();           ///< the nearest point of the surface is struck, m
  Vector3 direction = -Vector3::UnitZ();  ///< of the force; unit vector
  std::size_t listener = 0;               ///< index into SoundMap::listeners
};

/// A program in Faust, with one input, the force in newtons, and one output, the pressure in pascals. For a force that
/// is linear between samples it gives what sound_of() gives, without the delay to the listener.
[[nodiscard]] std::string faust_program(const store::SoundMap& map, const Strike& strike);

/// A glTF 2.0 file, as JSON with its data in it: the surface as a mesh, and the modes as a modal model of the draft
/// extension KHR_audio_rigid_bodies (docs/sound_map.md).
[[nodiscard]] std::string gltf_file(const store::SoundMap& map);

}  // namespace idiophone::modal
