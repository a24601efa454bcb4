#include "other_file.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace idiophone::app {

void require_other_file(const std::filesystem::path& made, const std::filesystem::path& source) {
  std::error_code ignored;  // what is not there is not overwritten
  if (std::filesystem::equivalent(made, source, ignored)) {
    throw std::runtime_error(fmt::format(
        "{} is read and would be overwritten; give the deck another name, or another --output-folder", made.string()));
  }
}

}  // namespace idiophone::app
