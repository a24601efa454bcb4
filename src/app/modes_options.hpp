#pragma once
// The options of `idiophone modes`.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "idiophone/scene/solids.hpp"

namespace idiophone::app {

struct ModesOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";
  std::string body;  ///< empty for the first
  int count = 20;    ///< of modes
  eigenmodes::MassMatrix mass = eigenmodes::MassMatrix::lumped;
  std::optional<double> shift;     ///< Hz below zero
  std::vector<double> references;  ///< Hz; empty for the deck's own
  double tolerance = 100.0;        ///< cents, of matches with references
  bool in_air = false;
  bool bounds = false;
  bool pictures = false;
  eigenmodes::Estimates estimates = eigenmodes::Estimates::quick;  ///< of the mesh's error
  Style style = Style::text;
};

/// Adds them to the command line.
void declare(CLI::App& app, ModesOptions& options);

/// @throws std::runtime_error for a number out of its range
void check(const ModesOptions& options);

/// @throws std::runtime_error for what is not known of bodies with joints
void refuse_with_joints(const ModesOptions& options, const scene::Solids& solids);

}  // namespace idiophone::app
