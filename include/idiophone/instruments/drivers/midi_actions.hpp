#pragma once
// What MIDI messages do, by what the score says of each note.

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "idiophone/instruments/drivers/force_budget.hpp"
#include "idiophone/instruments/drivers/live_strokes.hpp"
#include "idiophone/instruments/drivers/midi.hpp"

namespace idiophone::drivers {

/// A key strikes a body, or begins a stroke or a bow that goes on until it is released. The pressure on the keys leads
/// the load of all of them, as far as the score has it; the pitch wheel leads their speed from a quarter of that in the
/// score to four times as much.
class MidiActions {
 public:
  /// As LiveStrokes.
  MidiActions(std::vector<score::NoteAction> actions, std::uint64_t seed, int rate, std::int64_t lead);

  /// What keys do that are pressed from now on.
  void set(std::vector<score::NoteAction> actions) { actions_ = std::move(actions); }

  /// Adds the blow of a message, if it is one. @param now  audio sample
  /// @throws std::runtime_error when too many strokes or forces go on
  void take(const MidiMessage& message, std::int64_t now, std::vector<Event>& events);

  /// Adds the forces of strokes that come next. @param now  audio sample
  void ask(std::int64_t now, std::vector<Event>& events) { strokes_.ask(now, events); }

  /// Keys that were pressed and that the score has nothing for.
  [[nodiscard]] std::size_t unknown() const { return unknown_; }

 private:
  /// A key that is down.
  struct Held {
    double speed;       ///< of the score, m/s
    double whole_load;  ///< of the score, N
    double load;        ///< at present, N
  };
  void begin(const Note& note, const score::NoteAction& action, std::int64_t now);
  void press(const MidiMessage& message, std::int64_t now, std::vector<Event>& events);
  void release(int number);
  void lead();

  std::vector<score::NoteAction> actions_;
  int rate_;
  LiveStrokes strokes_;
  ForceBudget budget_;
  std::map<int, Held> held_;  // by the number of the key
  double faster_ = 1.0;       // than the score, by the pitch wheel
  std::size_t unknown_ = 0;
};

}  // namespace idiophone::drivers
