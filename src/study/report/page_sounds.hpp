#pragma once
// The sounds of a result with their partials, for the page.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "exposure.hpp"
#include "impacts.hpp"
#include "stretches.hpp"

namespace idiophone::report {

/// One channel of a listener.
struct Channel {
  std::string name;  ///< e.g. "ears.left"
  std::string unit;
  std::string attached;  ///< the body that carries the listener; empty for none
  double rate = 0.0;     ///< samples per second
  std::vector<double> samples;
  std::vector<Stretch> stretches;  ///< one for each blow, at least one
  Exposure exposure = {};
};

/// The sounds of a result, analysed.
struct Sounds {
  std::vector<Impact> impacts;         ///< at least one; of many, the loudest ones
  std::size_t left_out = 0;            ///< so many more impacts
  std::vector<Channel> channels = {};  ///< with a stretch for each of these impacts
};

/// @throws std::runtime_error if the result can't be read or has no sound
[[nodiscard]] Sounds read_sounds(const std::filesystem::path& result);

[[nodiscard]] nlohmann::json to_json(const Impact& impact);

/// Samples as whole numbers of 16 bits, partials and numbers of a channel.
[[nodiscard]] nlohmann::json to_json(const Channel& channel);

/// Partials of both sounds after their loudest impacts that belong together, with their distances, and the differences
/// as a whole.
[[nodiscard]] nlohmann::json compared(const Channel& first, const Channel& second);

}  // namespace idiophone::report
