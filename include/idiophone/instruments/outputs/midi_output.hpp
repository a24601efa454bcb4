#pragma once
// MIDI to devices and other programs, in real time, by JACK.

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace idiophone::outputs {

/// A message and when it is sent.
struct MidiMessage {
  double time = 0.0;  ///< s since the beginning
  std::array<unsigned char, 3> bytes{};
  std::size_t count = 3;  ///< of bytes
};

/// Sends messages from the MIDI output "idiophone:music" of JACK, each in the audio sample of its time, until all are
/// sent or `stop` says so. It then ends all notes.
/// @param messages     in the order of their times
/// @param destination  part of the name of the MIDI input to connect to; if empty, it waits until somebody connects the
///                     output
/// @throws std::runtime_error when there is no JACK server or no such input, when the server stops, and in a program
///         that was built without JACK
void play_midi(std::vector<MidiMessage> messages, const std::string& destination, const std::function<bool()>& stop);

}  // namespace idiophone::outputs
