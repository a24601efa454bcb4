#pragma once
// Where things are in a sound map, for those who write and read it (docs/use/sound_map.md).

#include <cstdint>
#include <filesystem>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

namespace sound_map {

inline constexpr const char* resolved_deck = "/resolved_deck";
inline constexpr const char* frequency = "/modes/frequency";
inline constexpr const char* decay = "/modes/decay";
inline constexpr const char* material_decay = "/modes/material_decay";
inline constexpr const char* radiation_decay = "/modes/radiation_decay";
inline constexpr const char* mesh_error = "/modes/mesh_error";
inline constexpr const char* shape = "/modes/shape";
inline constexpr const char* vertices = "/surface/vertices";
inline constexpr const char* triangles = "/surface/triangles";
inline constexpr const char* listener_names = "/listeners/name";
inline constexpr const char* listener_positions = "/listeners/position";
inline constexpr const char* listener_delays = "/listeners/delay";
inline constexpr const char* listener_pressure = "/listeners/pressure";
inline constexpr const char* directions = "/sphere/direction";
inline constexpr const char* weights = "/sphere/weight";
inline constexpr const char* sphere_pressure = "/sphere/pressure";
inline constexpr const char* scaling = "/scaling";
inline constexpr const char* stiffness = "/scaling/stiffness";
inline constexpr const char* mesh_shape = "/scaling/mesh_shape";
inline constexpr const char* lossless_frequency = "/scaling/lossless_frequency";
inline constexpr const char* stretching = "/stretching";
inline constexpr const char* stretching_linear = "/stretching/linear";
inline constexpr const char* stretching_quadratic = "/stretching/quadratic";
inline constexpr const char* stretching_rotation = "/stretching/rotation";
inline constexpr std::int64_t stretching_version = 1;  ///< attribute `version` of the group

}  // namespace sound_map

/// @param path  for the message
/// @throws std::runtime_error naming the first thing in a map that can't be: sizes that contradict each other, vertices
///         that do not exist, numbers that are not finite or out of their range
void check_sound_map(const SoundMap& map, const std::filesystem::path& path);

}  // namespace idiophone::sound_maps
