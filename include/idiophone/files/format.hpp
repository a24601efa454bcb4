#pragma once
// Names and versions of the file formats.

#include <cstdint>
#include <filesystem>
#include <string>

#include "idiophone/files/hdf5.hpp"
#include "idiophone/foundation/origin.hpp"

namespace idiophone::files {

inline const std::string result_format = "idiophone result";
inline const std::string checkpoint_format = "idiophone checkpoint";
inline const std::string surface_motion_format = "idiophone surface motion";
inline const std::string sound_map_format = "idiophone sound map";
inline const std::string mesh_format = "idiophone mesh";
inline const std::string radiation_format = "idiophone radiation";

/// The version of a format's layout.
[[nodiscard]] inline std::int64_t version_of(const std::string& format) {
  return format == checkpoint_format ? 5 : 1;
}

/// The format of a file; empty if it names none.
[[nodiscard]] std::string format_of(hid_t file);

/// @throws std::runtime_error unless the file is of this format and version; `path` is for the message.
void check_format(hid_t file, const std::string& format, const std::filesystem::path& path);

/// Begins a new file with its format and rank 0's origin. Collective.
void write_origin(hid_t file, const std::string& format, const Origin& origin, MPI_Comm communicator);

}  // namespace idiophone::files
