#pragma once
// The sounds of a result with their partials, for the page.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "idiophone/run/results/sound_reader.hpp"
#include "idiophone/study/partials/partials.hpp"

namespace idiophone::report {

/// One channel of a listener.
struct Channel {
  std::string name;  ///< e.g. "ears.left"
  std::string unit;
  std::string attached;  ///< the body that carries the listener; empty for none
  double rate = 0.0;     ///< samples per second
  std::vector<double> samples;
  double start = 0.0;     ///< of the analysis, s
  double duration = 0.0;  ///< of the analysis, s
  partials::Partials partials = {};
  double exposure = 0.0;  ///< A-weighted sound exposure, dB re one unit^2 s
};

/// All channels of a result, analysed.
/// @throws std::runtime_error if it can't be read or has no sound
[[nodiscard]] std::vector<Channel> read_channels(const std::filesystem::path& result);

/// Samples as whole numbers of 16 bits, partials and numbers of a channel.
[[nodiscard]] nlohmann::json to_json(const Channel& channel);

/// Partials of both sounds that belong together, with their distances, and the differences as a whole.
[[nodiscard]] nlohmann::json compared(const Channel& first, const Channel& second);

}  // namespace idiophone::report
