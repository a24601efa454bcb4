#pragma once
// The sound of a run in its result: one series for each listener.

#include <cstdint>

#include "idiophone/air/propagation/audio_path.hpp"
#include "idiophone/run/results/result_file.hpp"

namespace idiophone::record {

/// Adds a series for each listener, and the frequencies the sound is expected to have, to a new result. Collective.
void declare_sound(const propagation::AudioPath& audio_path, results::ResultFile& result);

/// Writes the audio samples that are final. Collective.
/// @param most  audio samples in the result at the most
void write_sound(propagation::AudioPath& audio_path, std::int64_t most, results::ResultFile& result);

}  // namespace idiophone::record
