#pragma once
// Decks of `idiophone listen`: listeners and radiation for a recorded motion.

#include "idiophone/scene/scene.hpp"

namespace idiophone::scene {

/// Properties of a recording.
struct RecordedDeck {
  std::filesystem::path recording;     ///< path of the file
  std::string name;                    ///< of the run
  std::string text;                    ///< of the run's deck, verbatim; empty if there is none
  std::vector<std::string> overrides;  ///< the run's --set arguments, verbatim
  int rate = 44100;                    ///< audio samples per second
  AirProperties air;                   ///< of the recorded run
  bool has_times = true;               ///< false: single frequencies; then `audio` and `output` are refused
};

/// Reads and validates a deck for listening: name, listeners, radiation, audio.dc_block or dc_corner, output.wav and
/// wav_full_scale. Omitted keys have the values of the recording's deck. The rest of the scene (bodies, loads, ...)
/// is empty.
/// @param deck       a YAML file; if empty, the recording's deck alone
/// @param overrides  "key.path=value" each, applied last
/// @return  its name is NAME_listen if the deck has none
/// @throws deck::DeckError that lists all mistakes with their places; std::runtime_error if the file can't be read.
[[nodiscard]] Scene read_listening(const RecordedDeck& recorded, const std::filesystem::path& deck,
                                   const std::vector<std::string>& overrides);

/// The deck as read_listening() reads it: with overrides, defaults and absolute names of files. YAML.
/// @throws as read_listening()
[[nodiscard]] std::string resolved_listening(const RecordedDeck& recorded, const std::filesystem::path& deck,
                                             const std::vector<std::string>& overrides);

}  // namespace idiophone::scene
