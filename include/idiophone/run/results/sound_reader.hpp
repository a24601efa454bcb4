#pragma once
// Reading sounds back from a finished (or stopped) result, without MPI: for `analyze`, WAV writers and scripts.

#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/foundation/spectra/listener_sound.hpp"

namespace idiophone::results {

/// Frequencies that a sound is expected to have.
struct ReferenceFrequencies {
  std::string name;
  std::vector<double> frequencies;  ///< Hz
};

/// All sounds of a result, by name.
/// @throws std::runtime_error if the file can't be opened or is not a result of idiophone.
[[nodiscard]] std::vector<spectra::Sound> read_sounds(const std::filesystem::path& result);

/// All references of a result, in the deck's order.
/// @throws std::runtime_error if the file can't be opened or is not a result of idiophone.
[[nodiscard]] std::vector<ReferenceFrequencies> read_references(const std::filesystem::path& result);

}  // namespace idiophone::results
