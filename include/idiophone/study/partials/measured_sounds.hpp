#pragma once
// The sounds of a result or of a sound file, and what else analyses need of results.

#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/run/results/sound_reader.hpp"

namespace idiophone::partials {

/// Whether a file is a result by its name, NAME.h5; otherwise it is a sound file.
[[nodiscard]] bool is_result_file(const std::filesystem::path& path);

/// All sounds of a result; or the one sound of a file that libsndfile can read (WAV, FLAC, ...), which has no unit.
/// @throws std::runtime_error if the file can't be read
[[nodiscard]] std::vector<spectra::Sound> read_sounds(const std::filesystem::path& path);

/// How far a body turned.
struct TurnedBody {
  std::string body;
  double degrees = 0.0;
};

/// The largest rotation of each body away from its orientation at `start`, until `end` (s), if the result has
/// orientations.
[[nodiscard]] std::vector<TurnedBody> turned_bodies(const std::filesystem::path& result, double start, double end);

/// What does work on the bodies of a result.
struct ActingForce {
  std::string name;    ///< "loads", or "contact NAME"
  double until = 0.0;  ///< s, when its sound arrives for the last time in the part, at most the end of it
};

/// The forces whose sound a listener hears from `start` to `end` (s), so that the bodies do not vibrate freely then:
/// pulses, winds, bows and driven groups, by the work that they do (where the result has energies), and contacts that
/// open or close. Sound travels straight from the point of a contact, and from the middle of the farthest body for
/// loads, to where the listener is at the beginning.
/// @throws std::invalid_argument if there is no such listener
[[nodiscard]] std::vector<ActingForce> acting_forces(const std::filesystem::path& result, const std::string& listener,
                                                     double start, double end);

}  // namespace idiophone::partials
