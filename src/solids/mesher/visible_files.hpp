#pragma once
// Which files gmsh can ask about.

#include <filesystem>

namespace idiophone::mesher {

/// From here on, files outside of `folder` do not exist for stat() and access() in this process. A geometry file asks
/// by FileExists, and Landlock keeps back only what is in a file.
void show_only(const std::filesystem::path& folder);

}  // namespace idiophone::mesher
