#include "command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/version.hpp"

namespace idiophone::app {

namespace {

/// What --help says first.
std::string introduction(const std::vector<Command>& commands) {
  std::vector<std::string> on_several;
  for (const Command& command : commands) {
    if (command.ranks == Ranks::any) {
      on_several.push_back(fmt::format("`{}`", command.name));
    }
  }
  return fmt::format(
      "From a deck and a mesh to the exact sound of a struck, plucked, dropped or bent solid object.\n"
      "Start {} under mpirun to use several ranks. PETSc's options (-log_view, ...) come last.",
      fmt::join(on_several, ", "));
}

}  // namespace

CommandLine::CommandLine() : commands_(commands()), parser_(introduction(commands_)) {
  parser_.set_version_flag("--version", program_version);
  parser_.require_subcommand(1);
  for (const Command& command : commands_) {
    command.declare(*parser_.add_subcommand(command.name, command.summary));
  }
}

const Command& CommandLine::command() const {
  return *std::ranges::find_if(commands_, [&](const Command& command) { return parser_.got_subcommand(command.name); });
}

int call(const Command& command) {
  if (command.ranks == Ranks::one && parallel::size_of(MPI_COMM_WORLD) > 1) {
    throw std::runtime_error(fmt::format("{} uses one process; start it without mpirun", command.name));
  }
  return command.call();
}

}  // namespace idiophone::app
