#pragma once
// The blows of a score as MIDI, for synthesizers and samplers.

#include <cstddef>
#include <vector>

#include "idiophone/instruments/drivers/midi.hpp"
#include "idiophone/instruments/score/score.hpp"

namespace idiophone::drivers {

/// The notes of blows, the reverse of blows_of().
struct ScoreNotes {
  std::vector<Note> notes;   ///< in the order of their times
  std::size_t left_out = 0;  ///< events that are no blows, or on a body that no note strikes
};

/// A blow becomes the note that strikes the same body nearest to the same point. Its velocity is 127 for the speed of
/// that note's hammer, and less or more in proportion: 1 to 127.
/// @param actions  what notes do; those that are strokes do not count
[[nodiscard]] ScoreNotes notes_of(const std::vector<score::ScoreEvent>& events,
                                  const std::vector<score::NoteAction>& actions);

/// Messages on the first channel, in the order of their times. A note ends after 0.25 s, or when it is struck again.
/// @param notes  in the order of their times
[[nodiscard]] std::vector<outputs::MidiMessage> messages_of(const std::vector<Note>& notes);

}  // namespace idiophone::drivers
