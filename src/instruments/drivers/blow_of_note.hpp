#pragma once
// What the score says of a MIDI note.

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <vector>

#include "idiophone/instruments/drivers/midi.hpp"
#include "idiophone/instruments/score/score.hpp"

namespace idiophone::drivers {

/// When a player asks, ns.
inline std::int64_t steady_clock() {
  return std::chrono::steady_clock::now().time_since_epoch().count();
}

/// What a note does; null if nothing.
inline const score::NoteAction* action_of(const Note& note, const std::vector<score::NoteAction>& actions) {
  const auto found = std::ranges::find(actions, note.number, &score::NoteAction::note);
  return found == actions.end() ? nullptr : &*found;
}

/// The blow of a note. @param action  of the note
inline score::ScoreEvent blow_of(const Note& note, const score::NoteAction& action) {
  score::HammerBlow blow = action.blow;
  blow.hammer.speed *= note.velocity / 127.0;
  return {note.time, action.body, blow};
}

}  // namespace idiophone::drivers
