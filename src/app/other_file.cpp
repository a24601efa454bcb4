#include "other_file.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace idiophone::app {

void require_other_file(const std::filesystem::path& made, const std::filesystem::path& source,
                        const std::string& remedy) {
  std::error_code ignored;  // what is not there is not overwritten
  if (std::filesystem::equivalent(made, source, ignored)) {
    throw std::runtime_error(fmt::format("{} is read and would be overwritten; {}", made.string(), remedy));
  }
}

}  // namespace idiophone::app
