#pragma once
// Files that are either the old one or the new one, whatever happens while they are written.

#include <filesystem>
#include <string>

namespace idiophone::store {

/// Makes sure that a file or directory is on the disk. @throws std::runtime_error with the system's reason
void synchronise(const std::filesystem::path& path);

/// Renames, then makes sure that the directory is on the disk. @throws std::runtime_error with the system's reason
void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to);

/// Replaces a text file: writes PATH.part, then renames it. @throws std::runtime_error with the system's reason
void write_atomically(const std::filesystem::path& path, const std::string& text);

}  // namespace idiophone::store
