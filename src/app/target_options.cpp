#include "target_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace idiophone::app {

void add_target(CLI::App& app, TargetOptions& options) {
  app.add_option("--target", options.target, "frequencies or notes, e.g. 187,F#5, or ratios, e.g. 1:4:10")->required();
  app.add_option("--pitch", options.pitch, "note or Hz of the first of the ratios (default: any)");
  app.add_option("--mode-numbers", options.modes, "of the modes to tune, at the start (default: the lowest)")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--a4", options.a4, "Hz, of the note A4")->capture_default_str();
}

fitting::Target target_of(const TargetOptions& options) {
  if (!(options.a4 > 0 && std::isfinite(options.a4))) {
    throw std::runtime_error(fmt::format("--a4 must be above 0 Hz, not {}", options.a4));
  }
  return fitting::read_target(options.target, options.pitch, options.a4);
}

std::vector<int> modes_to_tune(const TargetOptions& options, const fitting::Target& target) {
  std::vector<int> modes = options.modes;
  if (modes.empty()) {
    modes.resize(target.values.size());
    std::iota(modes.begin(), modes.end(), 1);
  }
  if (modes.size() != target.values.size()) {
    throw std::runtime_error(
        fmt::format("--target has {} values, but --mode-numbers {}", target.values.size(), modes.size()));
  }
  for (const int mode : modes) {
    if (mode < 1 || std::ranges::count(modes, mode) > 1) {
      throw std::runtime_error(fmt::format("--mode-numbers: {} is below 1 or given twice", mode));
    }
  }
  return modes;
}

}  // namespace idiophone::app
