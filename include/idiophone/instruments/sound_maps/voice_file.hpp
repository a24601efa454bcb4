#pragma once
// NAME.voice: what the sound of a map needs, in a flat file for programs without HDF5 (docs/use/engines.md).

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

/// The bytes of the file: the map without its decks and the errors of its mesh.
/// @throws std::runtime_error when sizes of the map contradict each other
[[nodiscard]] std::string voice_file(const SoundMap& map);

/// Of the bytes that follow it in a voice file: FNV-1a (G. Fowler, L. C. Noll, K.-P. Vo). It finds damage, not ill
/// will.
[[nodiscard]] std::uint64_t voice_checksum(std::span<const char> bytes);

/// @param bytes  of the whole file
/// @param name   of the file, for messages
/// @throws std::runtime_error when it is no voice file, of another version, damaged, or contradicts itself
[[nodiscard]] SoundMap read_voice(std::span<const char> bytes, const std::string& name);

/// @throws std::runtime_error also when the file can't be opened
[[nodiscard]] SoundMap read_voice(const std::filesystem::path& path);

}  // namespace idiophone::sound_maps
