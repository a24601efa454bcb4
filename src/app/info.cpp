#include <fmt/format.h>

#include "commands.hpp"
#include "idiophone/store/describe.hpp"
#include "stop.hpp"

namespace idiophone::app {

int info(const std::filesystem::path& file) {
  fmt::print("{}", store::describe(file));
  return exit_finished;
}

}  // namespace idiophone::app
