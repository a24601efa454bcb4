#pragma once
// Files that are made from others.

#include <filesystem>
#include <string>

namespace idiophone::app {

/// @param remedy  what to do about it
/// @throws std::runtime_error if a file would be written over the one that it is made from
void require_other_file(const std::filesystem::path& made, const std::filesystem::path& source,
                        const std::string& remedy = "give the deck another name, or another --output-folder");

}  // namespace idiophone::app
