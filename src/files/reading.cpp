#include "idiophone/files/reading.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace idiophone::files {

void rethrow_naming(const std::filesystem::path& file) {
  try {
    throw;
  } catch (const std::runtime_error& error) {
    if (const std::string said = error.what(); said.find(file.string()) == std::string::npos) {
      throw std::runtime_error(fmt::format("{}: {}", file.string(), said));
    }
    throw;
  }
}

}  // namespace idiophone::files
