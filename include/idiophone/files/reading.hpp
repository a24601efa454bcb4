#pragma once
// Reading a file that may be damaged, or another program's.

#include <filesystem>
#include <stdexcept>

#include "idiophone/files/reading_limit.hpp"

namespace idiophone::files {

/// Throws the present std::runtime_error with the file's name in its message.
[[noreturn]] void rethrow_naming(const std::filesystem::path& file);

/// Calls `read()`, whose errors of type std::runtime_error then name the file.
template <class Read>
auto read_naming(const std::filesystem::path& file, const Read& read) {
  try {
    return read();
  } catch (const std::runtime_error&) {
    rethrow_naming(file);
  }
}

/// Likewise, within a ReadingLimit.
template <class Read>
auto read_within_limit(const std::filesystem::path& file, const Read& read) {
  const ReadingLimit limit(file);
  return read_naming(file, read);
}

}  // namespace idiophone::files
