#pragma once
// Decks for listening to a motion that was recorded: who hears it, and how it travels there.

#include "idiophone/scene/scene.hpp"

namespace idiophone::scene {

/// What a recording says to those who listen to it.
struct RecordedDeck {
  std::filesystem::path recording;     ///< where it was read from
  std::string name;                    ///< of the run
  std::string text;                    ///< of the run's deck, verbatim; empty where there is none
  std::vector<std::string> overrides;  ///< the run's --set arguments, verbatim
  int rate = 44100;                    ///< audio samples per second
  AirProperties air;                   ///< that the surfaces moved in
};

/// Reads and validates a deck for listening: name, listeners, radiation, audio.dc_block or dc_corner, output.wav and
/// wav_full_scale. What it does not say is as in the recording's own deck; the rest of a scene (bodies, loads, ...) is
/// empty.
/// @param deck       a YAML file; empty for nothing but the recording's own deck
/// @param overrides  "key.path=value" each, applied last
/// @return  named NAME_listen where the deck does not give a name
/// @throws deck::DeckError with every mistake found, each with its place; std::runtime_error if the file can't be read.
[[nodiscard]] Scene read_listening(const RecordedDeck& recorded, const std::filesystem::path& deck,
                                   const std::vector<std::string>& overrides);

/// The deck that read_listening() read, with the overrides in their places, the defaults of the keys that it leaves
/// out, and absolute names of files: YAML.
/// @throws as read_listening()
[[nodiscard]] std::string resolved_listening(const RecordedDeck& recorded, const std::filesystem::path& deck,
                                             const std::vector<std::string>& overrides);

}  // namespace idiophone::scene
