#pragma once
// Files that are made from others.

#include <filesystem>

namespace idiophone::app {

/// @throws std::runtime_error if a file would be written over the one that it is made from
void require_other_file(const std::filesystem::path& made, const std::filesystem::path& source);

}  // namespace idiophone::app
