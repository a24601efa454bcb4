#pragma once
// Options of commands that tune: which modes, and to what.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/study/fitting/target.hpp"

namespace idiophone::app {

struct TargetOptions {
  std::string target;                  ///< frequencies, notes or ratios
  std::optional<std::string> pitch;    ///< of the first of the ratios
  std::vector<int> modes;              ///< from 1 on; empty for the lowest
  double a4 = fitting::concert_pitch;  ///< Hz
};

/// --target, --pitch, --mode-numbers and --a4
void add_target(CLI::App& app, TargetOptions& options);

/// @throws std::runtime_error if the text of an option has no meaning
[[nodiscard]] fitting::Target target_of(const TargetOptions& options);

/// Numbers of the modes to tune: those given, or the lowest ones. [values of the target]
/// @throws std::runtime_error if there are more or fewer than values of the target, or a number is wrong
[[nodiscard]] std::vector<int> modes_to_tune(const TargetOptions& options, const fitting::Target& target);

}  // namespace idiophone::app
