#pragma once
// WAV files, through libsndfile.

#include <cstddef>
#include <filesystem>
#include <span>

namespace idiophone::spectra {

enum class SampleFormat { float32, pcm24, pcm16 };

/// Format of the file.
struct WavOptions {
  int rate = 44100;
  int channels = 1;
  SampleFormat format = SampleFormat::float32;
  double full_scale = 1.0;  ///< the value that becomes 1.0 (float32) or the largest number (pcm)
};

/// Replaces `path`. The file gets its name when it is complete.
/// @param samples  [channels x frames], a frame's channels side by side
/// @return  the number of samples above full scale; pcm clips them, float32 does not
/// @throws std::invalid_argument if an option is out of range, samples are not whole frames or not finite, also when
///         they are divided by the full scale, or the file would exceed a WAV file's 4 GB; std::runtime_error if it
///         can't be written
std::size_t write_wav(const std::filesystem::path& path, std::span<const double> samples, const WavOptions& options);

}  // namespace idiophone::spectra
