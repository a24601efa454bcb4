#pragma once
// What a command of the program is: one file that makes one row of the table in commands.cpp.

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "shared_options.hpp"

namespace idiophone::app {

/// On how many processes a command can be started.
enum class Ranks {
  one,  ///< alone, without mpirun
  any   ///< alone or under mpirun; its call is then collective
};

struct Command {
  std::string name;
  std::string summary;  ///< a line of --help
  Ranks ranks = Ranks::one;
  std::function<void(CLI::App&)> declare;  ///< adds its options to its part of the command line, which fills them
  std::function<int()> call;     ///< by the options that were parsed; returns the exit status, throws what went wrong
  std::function<Style()> style;  ///< how it answers by these options
};

/// @tparam Options  of the command; those with a `style` answer scripts, too
template <class Options>
[[nodiscard]] Command make_command(std::string_view name, std::string_view summary, Ranks ranks,
                                   void (*declare)(CLI::App&, Options&), int (*call)(const Options&)) {
  const auto options = std::make_shared<Options>();
  const auto style = [options] {
    if constexpr (requires { options->style; }) {
      return options->style;
    } else {
      return Style::text;
    }
  };
  return {.name = std::string(name),
          .summary = std::string(summary),
          .ranks = ranks,
          .declare = [options, declare](CLI::App& app) { declare(app, *options); },
          .call = [options, call] { return call(*options); },
          .style = style};
}

}  // namespace idiophone::app
