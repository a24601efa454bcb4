#pragma once
// Reading sounds back from a finished (or stopped) result, without MPI: for `analyze`, WAV writers and scripts.

#include <filesystem>
#include <string>
#include <vector>

namespace idiophone::results {

/// One listener's channels.
struct Sound {
  std::string name;                          ///< of the listener
  double rate = 0.0;                         ///< samples per second
  std::string unit;                          ///< of the samples, e.g. "Pa m"
  std::vector<std::string> channels;         ///< their names
  std::vector<std::vector<double>> samples;  ///< [channels][samples]
  std::string attached = {};                 ///< the body that carries the listener; empty for none
};

/// Frequencies that a sound is expected to have.
struct ReferenceFrequencies {
  std::string name;
  std::vector<double> frequencies;  ///< Hz
};

/// All sounds of a result, by name.
/// @throws std::runtime_error if the file can't be opened or is not a result of idiophone.
[[nodiscard]] std::vector<Sound> read_sounds(const std::filesystem::path& result);

/// All references of a result, in the deck's order.
/// @throws std::runtime_error if the file can't be opened or is not a result of idiophone.
[[nodiscard]] std::vector<ReferenceFrequencies> read_references(const std::filesystem::path& result);

/// Frequencies of the modes of each body in a file of `idiophone modes`, by the body's name.
/// @throws std::runtime_error if the file can't be opened or is not a result of idiophone.
[[nodiscard]] std::vector<ReferenceFrequencies> read_mode_frequencies(const std::filesystem::path& modes);

}  // namespace idiophone::results
