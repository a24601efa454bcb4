#pragma once
// Drivers of people who play: MIDI notes and OSC messages.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "idiophone/instruments/drivers/driver.hpp"
#include "idiophone/instruments/drivers/few_warnings.hpp"
#include "idiophone/instruments/drivers/force_budget.hpp"
#include "idiophone/instruments/drivers/live_strokes.hpp"
#include "idiophone/instruments/drivers/midi.hpp"
#include "idiophone/instruments/drivers/midi_actions.hpp"
#include "idiophone/instruments/drivers/osc.hpp"

namespace idiophone::drivers {

/// The blows of notes, by what the score says that each note does. Notes that are strokes have none.
struct NoteBlows {
  std::vector<score::ScoreEvent> events;
  std::size_t unknown = 0;  ///< notes that the score has nothing for
};
[[nodiscard]] NoteBlows blows_of(const std::vector<Note>& notes, const std::vector<score::NoteAction>& actions);

/// Messages that come to the MIDI input of JACK.
class MidiPlayer : public Driver {
 public:
  /// As MidiActions. @throws as JackMidi
  MidiPlayer(std::vector<score::NoteAction> actions, std::uint64_t seed, int rate, std::int64_t lead);

  void ask(std::int64_t now, std::int64_t until, std::vector<Event>& events) override;
  [[nodiscard]] bool is_live() const override { return true; }
  [[nodiscard]] std::string complaint() const override;

 private:
  JackMidi midi_;
  MidiActions actions_;
  FewWarnings warnings_;
};

/// OSC messages.
class OscPlayer : public Driver {
 public:
  static constexpr double patience = 10.0;  ///< s, after which a stroke ends of which no message is heard

  /// @param address  as OscServer
  /// @param port    UDP; 0 takes any free port
  /// @param bodies  their names, as messages have them
  /// @param seed    of roughness
  /// @param lead    audio samples by which voices know ahead what begins
  /// @throws as OscServer
  OscPlayer(const std::string& address, int port, std::vector<std::string> bodies, std::uint64_t seed, int rate,
            std::int64_t lead = 0);

  void ask(std::int64_t now, std::int64_t until, std::vector<Event>& events) override;
  [[nodiscard]] bool is_live() const override { return true; }
  [[nodiscard]] std::string complaint() const override;

  /// The UDP port on which it hears.
  [[nodiscard]] int port() const { return server_.port(); }

 private:
  void play(const score::ScoreEvent& event);

  std::uint64_t seed_;
  int rate_;
  std::int64_t now_ = 0;       // while messages are handled
  std::vector<Event> events_;  // that came in
  ForceBudget budget_;
  LiveStrokes strokes_;
  OscServer server_;
};

}  // namespace idiophone::drivers
