#pragma once
// Levels and loudness of a sound, as `idiophone analyze` prints them.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "idiophone/foundation/spectra/listener_sound.hpp"
#include "idiophone/study/levels/levels.hpp"
#include "idiophone/study/levels/loudness.hpp"

namespace idiophone::app {

/// The levels of all channels of a listener, and their loudness together.
struct LevelAnswer {
  double start = 0.0;       ///< of the part that was measured, s
  double duration = 0.0;    ///< s
  std::string reference;    ///< of the levels: "20 uPa", "1 Pa m", "full scale"
  double full_scale = 1.0;  ///< of the loudness, in the unit of the samples: 1 for sound files, otherwise the peak
  std::vector<levels::Levels> channels = {};
  levels::Loudness loudness = {};
};

/// Measures a part of a sound.
/// @param start     s
/// @param duration  s; to the end if it is longer
/// @throws std::invalid_argument if there is no sample in this part
[[nodiscard]] LevelAnswer measure_levels(const spectra::Sound& sound, double start, double duration);

/// Prints all of them, with a table of third octaves.
void print_levels(const spectra::Sound& sound, const LevelAnswer& answer);

/// Those of one channel, and the loudness of its listener.
[[nodiscard]] nlohmann::json to_json(const LevelAnswer& answer, std::size_t channel);

}  // namespace idiophone::app
