#pragma once
// The facts about a recorded surface motion (docs/use/surface_motion.md), which are beside its tables.

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "idiophone/air/surface/recording.hpp"

namespace idiophone::results {

/// How large the tables of a recording are.
struct RecordingSize {
  std::int64_t rows = 0, triangles = 0, vertices = 0;
};

/// Contents of a damaged file can be anything.
/// @throws std::runtime_error that names the file, unless the condition holds
void require(bool condition, const std::filesystem::path& path, const std::string& problem);

[[nodiscard]] bool has_dataset(hid_t file, const std::string& path);

/// @return audio samples per second
/// @throws std::runtime_error when the file says none, or one that can't be
[[nodiscard]] double read_recording_rate(hid_t file, const std::filesystem::path& path);

/// @throws std::runtime_error when the file contradicts itself
[[nodiscard]] surface::RecordingHeader read_recording_header(hid_t file, const std::filesystem::path& path,
                                                             const RecordingSize& size);

}  // namespace idiophone::results
