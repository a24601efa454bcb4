#pragma once
// Recordings in sound files: WAV, FLAC and all other formats of libsndfile.

#include <filesystem>
#include <vector>

namespace idiophone::spectra {

struct SoundFile {
  double rate = 0.0;                          ///< samples per second
  std::vector<std::vector<double>> channels;  ///< [channels][samples], 1 is full scale
};

/// @throws std::runtime_error, with libsndfile's reason, if the file can't be read
[[nodiscard]] SoundFile read_sound_file(const std::filesystem::path& path);

}  // namespace idiophone::spectra
