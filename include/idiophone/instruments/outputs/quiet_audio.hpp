#pragma once
// ALSA and JACK write to standard error whatever they try in vain when PortAudio looks for devices.

namespace idiophone::outputs {

/// Silences both for the rest of the process. Errors that matter are reported by their callers.
void silence_audio_libraries();

}  // namespace idiophone::outputs
