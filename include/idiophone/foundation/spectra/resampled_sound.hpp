#pragma once
// Recorded sounds.

#include <filesystem>
#include <vector>

namespace idiophone::spectra {

/// The samples of a sound file with one channel (WAV, FLAC, AIFF, ... by libsndfile), converted to the rate by
/// libsamplerate.
/// @return full scale is 1
/// @throws std::runtime_error if the file can't be read or has several channels
[[nodiscard]] std::vector<double> read_sound_file(const std::filesystem::path& file, int rate);

}  // namespace idiophone::spectra
