#pragma once
// NAME.map.h5: sound maps are read and written by one process, without MPI calls.

#include <filesystem>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

/// Writes a map, or replaces a file by it. The file is either the old one or the new one, whatever happens.
/// @throws std::runtime_error with the system's reason, or when sizes of the map contradict each other
void write_sound_map(const std::filesystem::path& path, const SoundMap& map);

/// @throws std::runtime_error when the file can't be opened, is no sound map, is damaged, or contradicts itself
[[nodiscard]] SoundMap read_sound_map(const std::filesystem::path& path);

}  // namespace idiophone::sound_maps
