#pragma once
// Notes and messages from MIDI files, and notes from JACK.

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/instruments/outputs/midi_output.hpp"

namespace idiophone::drivers {

/// A key that is struck.
struct Note {
  double time = 0.0;  ///< s, in a file
  int number = 0;     ///< 0 to 127
  int velocity = 0;   ///< 1 to 127
};

/// What a player does on a keyboard, on any channel.
struct MidiMessage {
  enum class Kind {
    press,     ///< a key, with a velocity
    release,   ///< of a key
    pressure,  ///< on all keys that are down
    bend       ///< of the pitch wheel
  };
  Kind kind = Kind::press;
  int number = 0;  ///< of the key, 0 to 127
  int value = 0;   ///< velocity 1 to 127, pressure 0 to 127, bend -8192 to 8191
};

/// @param bytes  of one message
/// @return none for a message of another kind
[[nodiscard]] std::optional<MidiMessage> midi_message(std::span<const unsigned char> bytes);

/// All notes of a standard MIDI file, on all channels, in the order of their times.
/// @throws std::runtime_error when it can't be read
[[nodiscard]] std::vector<Note> read_midi_file(const std::filesystem::path& file);

/// All messages of a standard MIDI file for instruments, in the order of their times.
/// @throws as read_midi_file()
[[nodiscard]] std::vector<outputs::MidiMessage> read_midi_messages(const std::filesystem::path& file);

/// A MIDI input of JACK, "idiophone:midi".
class JackMidi {
 public:
  /// @throws std::runtime_error when there is no JACK server
  JackMidi();
  JackMidi(const JackMidi&) = delete;
  JackMidi(JackMidi&&) = delete;
  JackMidi& operator=(const JackMidi&) = delete;
  JackMidi& operator=(JackMidi&&) = delete;
  ~JackMidi();

  /// The next message that came in. False if there is none.
  bool take(MidiMessage& message);

  /// Messages that were lost because too many came in at once.
  [[nodiscard]] std::size_t lost() const;

 private:
  struct Client;
  std::unique_ptr<Client> client_;
};

}  // namespace idiophone::drivers
