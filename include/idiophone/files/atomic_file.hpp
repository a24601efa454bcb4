#pragma once
// Atomic replacement of files.

#include <filesystem>
#include <string>

namespace idiophone::files {

/// Synchronises a file or directory with the disk. @throws std::runtime_error with the system's reason
void synchronise(const std::filesystem::path& path);

/// Renames, then synchronises the directory. @throws std::runtime_error with the system's reason
void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to);

/// Replaces a text file: writes PATH.part, then renames it. @throws std::runtime_error with the system's reason
void write_atomically(const std::filesystem::path& path, const std::string& text);

}  // namespace idiophone::files
