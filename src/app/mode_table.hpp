#pragma once
// The table of modes that `idiophone modes` prints.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "modes_in_air.hpp"

namespace idiophone::app {

/// What is said of each mode.
struct ModeTable {
  const std::vector<eigenmodes::Mode>& modes;
  std::vector<double> mesh_errors;  ///< [modes] estimates, cents; empty without
  AirOfModes air;
  std::vector<std::string> kinds;  ///< [modes]; empty texts for unknown ones
  std::vector<partials::References> references;
  double tolerance;  ///< of matches with references, cents
};

void print(const ModeTable& table);

/// The same for scripts: an array of the modes.
[[nodiscard]] nlohmann::json to_json(const ModeTable& table);

}  // namespace idiophone::app
