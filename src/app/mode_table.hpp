#pragma once
// The table of modes that `idiophone modes` prints.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "mode_bounds.hpp"
#include "modes_in_air.hpp"

namespace idiophone::app {

/// What is said of each mode.
struct ModeTable {
  const std::vector<eigenmodes::Mode>& modes;
  std::vector<double> mesh_errors;  ///< [modes] estimates, cents; empty without
  AirOfModes air;
  const std::optional<eigenmodes::FrequencyBounds>& bounds;
  std::vector<std::string> kinds;   ///< [modes]; empty texts for unknown ones
  std::vector<std::string> bodies;  ///< names
  std::vector<partials::References> references;
  double tolerance;  ///< of matches with references, cents
  bool is_round;     ///< one body, whose modes come in pairs
};

/// Those of a deck, for the table.
[[nodiscard]] std::vector<partials::References> references_of(const scene::Scene& scene);

void print(const ModeTable& table);

/// The same for scripts: an array of the modes.
[[nodiscard]] nlohmann::json to_json(const ModeTable& table);

}  // namespace idiophone::app
