#pragma once
// The sounds of a result as WAV files.

#include <filesystem>

#include "idiophone/scene/scene.hpp"

namespace idiophone::app {

/// Writes a WAV file for each listener in NAME.h5: NAME.wav where there is one, NAME_LISTENER.wav where there are
/// several. Call on one rank.
/// @throws std::runtime_error when files can't be read or written
void write_wavs(const scene::Scene& scene, const std::filesystem::path& directory);

}  // namespace idiophone::app
