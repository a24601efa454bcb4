#pragma once
// What became of the bodies of `idiophone map`, and its answer.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "shared_options.hpp"

namespace idiophone::app {

/// Only rank 0 knows the maps and the reasons; all ranks know what was stopped.
struct MapOutcome {
  nlohmann::json maps = nlohmann::json::array();      ///< facts of those that are written
  nlohmann::json failures = nlohmann::json::array();  ///< {body, reason}: bodies without modes
  std::vector<std::string> stopped = {};  ///< what a signal left out: "20 of 40 modes of bell", "all modes of gong"
};

/// Writes a map. On rank 0.
void write_map(const std::filesystem::path& path, const sound_maps::SoundMap& map, Style style, MapOutcome& outcome);

/// Answers. On rank 0. @return the status of the program
[[nodiscard]] int report_maps(const MapOutcome& outcome, Style style);

}  // namespace idiophone::app
