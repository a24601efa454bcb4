#pragma once
// Text files that commands write.

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace idiophone {

/// Replaces the file. @throws std::runtime_error if it can't be written
inline void write_text(const std::filesystem::path& path, const std::string& text) {
  if (!(std::ofstream(path, std::ios::binary) << text).flush()) {
    throw std::runtime_error("can't write " + path.string());
  }
}

}  // namespace idiophone
