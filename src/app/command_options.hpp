#pragma once
// Options that several commands have.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "commands.hpp"

namespace idiophone::app {

inline void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
  command.add_option("--set", overrides, "KEY.PATH=VALUE: overrides a value of the deck; may be given again")
      ->take_all()
      ->expected(1);
}

/// @param options  with a deck and overrides
template <class Options>
void add_deck_options(CLI::App& command, Options& options) {
  command.add_option("deck", options.deck, "the scene, a YAML file (docs/use/deck.md)")->required();
  add_overrides(command, options.overrides);
}

/// @param options  with a directory and a way to tell progress
template <class Options>
void add_output_options(CLI::App& command, Options& options) {
  command.add_option("--output", options.output, "directory of the results")->capture_default_str();
  command.add_option("--progress", options.progress, "one updating line, or lines of a log (under mpirun: log)")
      ->check(CLI::IsMember({"auto", "line", "log"}))
      ->capture_default_str();
}

/// @param options  of a command that answers people or scripts
template <class Options>
void add_json_flag(CLI::App& command, Options& options) {
  command.add_flag_callback(
      "--json", [&options] { options.style = Style::json; }, "answer in JSON, for scripts");
}

}  // namespace idiophone::app
