#pragma once
// NAME.voice: what the sound of a map needs, in a flat file for programs without HDF5 (docs/use/engines.md).

#include <filesystem>
#include <span>
#include <string>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

/// The bytes of the file: the map without its decks and the errors of its mesh.
/// @throws std::runtime_error when sizes of the map contradict each other
[[nodiscard]] std::string voice_file(const SoundMap& map);

/// @param bytes  of the whole file
/// @param name   of the file, for messages
/// @throws std::runtime_error when it is no voice file, of another version, damaged, or contradicts itself
[[nodiscard]] SoundMap read_voice(std::span<const char> bytes, const std::string& name);

/// @throws std::runtime_error also when the file can't be opened
[[nodiscard]] SoundMap read_voice(const std::filesystem::path& path);

}  // namespace idiophone::sound_maps
