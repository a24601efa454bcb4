#pragma once
// Where things are in NAME_radiation.h5, for those who write and read it (docs/use/radiate.md).

#include <fmt/format.h>

#include <cstddef>
#include <string>

namespace idiophone::harmonic::radiation_paths {

inline constexpr const char* names = "/sounds/name";
inline constexpr const char* parts = "/surface/parts";
inline constexpr const char* first_triangle = "/surface/first_triangle";
inline constexpr const char* listener_names = "/listeners/name";
inline constexpr const char* listener_positions = "/listeners/position";
inline constexpr const char* listener_pressure = "/listeners/pressure";
inline constexpr const char* directions = "/sphere/direction";
inline constexpr const char* weights = "/sphere/weight";
inline constexpr const char* far_field = "/sphere/pressure";

// Attributes of the file.
inline constexpr const char* bodies = "bodies";
inline constexpr const char* cell = "waves_cell";
inline constexpr const char* floor_at = "floor_at";
inline constexpr const char* floor_normal = "floor_normal";
inline constexpr const char* floor_reflection = "floor_reflection";

inline constexpr const char* all_solutions = "/solutions";

/// The group of the sounds that were solved on a surface that was refined so many times.
[[nodiscard]] inline std::string solutions(std::size_t refinements) {
  return fmt::format("{}/{}", all_solutions, refinements);
}

}  // namespace idiophone::harmonic::radiation_paths
