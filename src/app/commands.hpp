#pragma once
// The table of commands.

#include <vector>

#include "command.hpp"

namespace idiophone::app {

/// All commands, in the order of --help, with options of their own.
[[nodiscard]] std::vector<Command> commands();

}  // namespace idiophone::app
