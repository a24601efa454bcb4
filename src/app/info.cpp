#include <fmt/format.h>

#include "commands.hpp"
#include "idiophone/store/describe.hpp"
#include "stop.hpp"

namespace idiophone::app {

int info(const InfoOptions& options) {
  fmt::print("{}",
             options.style == Style::json ? store::describe_as_json(options.file) : store::describe(options.file));
  return exit_finished;
}

}  // namespace idiophone::app
