#pragma once
// Who asks the bodies of a performance to sound.

#include <vector>

#include "idiophone/instruments/drivers/motion_drivers.hpp"
#include "idiophone/instruments/voices/stage.hpp"
#include "idiophone/timbre/playing/playing.hpp"

namespace idiophone::timbre {

/// The word that stands for JACK in the settings `midi` and `midi_out`.
inline constexpr const char* jack_as_midi = "jack";

/// What is known before: the score, a MIDI file, contacts and motion.
/// @param score   gets a duration if it has none and contacts strike the bodies
/// @param bodies  of the stage
[[nodiscard]] drivers::Drivers known_drivers(const PlaySettings& settings, score::Score& score,
                                             const std::vector<drivers::StruckBody>& bodies, int rate);

/// People who play by MIDI and OSC.
void add_players(const PlaySettings& settings, const score::Score& score, const voices::Stage& stage,
                 drivers::Drivers& drivers);

/// Sends the notes of the score and of a MIDI file to the MIDI input of the settings, with Ctrl-C as their end.
/// @return the number of messages
/// @throws std::runtime_error if there is no note; as outputs::play_midi()
std::size_t send_notes(const PlaySettings& settings, const score::Score& score);

}  // namespace idiophone::timbre
