#pragma once
// Sounds as WAV files.

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "idiophone/scene/scene.hpp"

namespace idiophone::loop {

struct WavSettings {
  int rate = 44100;  ///< audio samples per second
  int channels = 1;
  scene::WavFormat format = scene::WavFormat::float32;
  std::optional<double> full_scale;  ///< value that becomes 1.0; the loudest sample's if empty
  std::string full_scale_key;        ///< that sets it, for messages
  std::string unit = "Pa";
};

/// What would otherwise be found out after the computation.
/// @throws std::runtime_error when the file is a folder, or its folder does not exist
void require_folder_of(const std::filesystem::path& file);
/// @param samples  of all channels
/// @throws std::runtime_error as above, and for more samples than fit into a WAV file
void require_room_for_wav(const std::filesystem::path& file, double samples);

/// Writes a WAV file and logs its scale. Call on one rank.
/// @param samples  [channels x frames], a frame's channels side by side
/// @throws as spectra::write_wav()
void write_wav(const std::filesystem::path& path, std::span<const double> samples, const WavSettings& settings);

/// Writes a WAV file for each listener in NAME.h5: NAME.wav where there is one, NAME_LISTENER.wav where there are
/// several. Call on one rank.
/// @throws std::runtime_error when files can't be read or written
void write_wavs(const scene::Scene& scene, const std::filesystem::path& directory);

}  // namespace idiophone::loop
