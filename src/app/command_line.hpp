#pragma once
// The command line: the table of commands as parts of it.

#include <CLI/CLI.hpp>
#include <vector>

#include "commands.hpp"

namespace idiophone::app {

class CommandLine {
 public:
  /// Declares all commands.
  CommandLine();

  /// Parses with it; the options of one command are filled then.
  [[nodiscard]] CLI::App& parser() { return parser_; }

  /// The command that was parsed.
  [[nodiscard]] const Command& command() const;

 private:
  std::vector<Command> commands_;
  CLI::App parser_;
};

/// Calls a command. Collective.
/// @return the exit status
/// @throws std::runtime_error on several processes, if it can use only one; and what the command throws
[[nodiscard]] int call(const Command& command);

}  // namespace idiophone::app
