#pragma once
// What tells our files from others.

#include <cstdint>
#include <filesystem>
#include <string>

#include "hdf5.hpp"

namespace idiophone::store {

inline const std::string result_format = "idiophone result";
inline const std::string checkpoint_format = "idiophone checkpoint";
inline constexpr std::int64_t format_version = 1;  ///< of both; another number is another layout

/// The format that a file says it has; empty when it says nothing.
[[nodiscard]] std::string format_of(hid_t file);

/// @throws std::runtime_error unless the file is of this format and version; `path` is for the message.
void check_format(hid_t file, const std::string& format, const std::filesystem::path& path);

}  // namespace idiophone::store
