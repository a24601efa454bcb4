#include "idiophone/instruments/drivers/players.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "blow_of_note.hpp"

namespace idiophone::drivers {

namespace {

constexpr int most_midi_messages = 64;     // at once
constexpr std::int64_t stroke_lead = 512;  // audio samples by which a stroke begins later, so that all of it is there

}  // namespace

NoteBlows blows_of(const std::vector<Note>& notes, const std::vector<score::NoteAction>& actions) {
  NoteBlows blows;
  for (const Note& note : notes) {
    const score::NoteAction* action = action_of(note, actions);
    if (action != nullptr && action->strikes()) {
      blows.events.push_back(blow_of(note, *action));
    } else {
      ++blows.unknown;
    }
  }
  return blows;
}

MidiPlayer::MidiPlayer(std::vector<score::NoteAction> actions, std::uint64_t seed, int rate, std::int64_t lead)
    : actions_(std::move(actions), seed, rate, lead) {}

void MidiPlayer::ask(std::int64_t now, std::int64_t /*until*/, std::vector<Event>& events) {
  MidiMessage message;
  for (int i = 0; i < most_midi_messages && midi_.take(message); ++i) {
    try {
      actions_.take(message, now, events);
    } catch (const std::runtime_error& error) {
      warnings_.warn(fmt::format("MIDI note {}: {}", message.number, error.what()));
    }
  }
  actions_.ask(now, events);
}

std::string MidiPlayer::complaint() const {
  std::string text;
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) {
      text += fmt::format("{}{} MIDI {}", text.empty() ? "" : "; ", count, what);
    }
  };
  add(actions_.unknown(), "notes that the score has nothing for");
  add(warnings_.count(), "messages that could not be played");
  add(midi_.lost(), "messages that were lost because too many came at once");
  return text;
}

OscPlayer::OscPlayer(const std::string& address, int port, std::vector<std::string> bodies, std::uint64_t seed,
                     int rate, std::int64_t lead)
    : seed_(seed),
      rate_(rate),
      budget_(rate),
      strokes_(seed, rate, lead, patience),
      server_(address, port, std::move(bodies),
              {.play = [this](const score::ScoreEvent& event) { play(event); },
               .begin_stroke =
                   [this](const std::string& name, const score::ScoreEvent& event) {
                     if (const auto* bow = std::get_if<score::Bow>(&event.action)) {
                       strokes_.begin(name, event.body, *bow, now_);
                     } else {
                       strokes_.begin(name, event.body, std::get<score::Stroke>(event.action), now_);
                     }
                   },
               .change_stroke = [this](const std::string& name, double speed,
                                       double load) { strokes_.change(name, speed, load); },
               .end_stroke = [this](const std::string& name) { strokes_.end(name); },
               .move_listener =
                   [this](const Vector3& place) {
                     events_.push_back({.start = now_, .action = ListenerMove{place}, .sent = steady_clock()});
                   }}) {}

void OscPlayer::play(const score::ScoreEvent& event) {
  const std::int64_t sent = steady_clock();
  budget_.take(event, now_);
  const bool moves = std::holds_alternative<score::Stroke>(event.action);
  events_.push_back(event_of(event, now_ + (moves ? stroke_lead : 0), seed_, rate_));
  events_.back().sent = sent;
}

std::string OscPlayer::complaint() const {
  return server_.refused() > 0 ? fmt::format("{} OSC messages were wrong and left out", server_.refused()) : "";
}

void OscPlayer::ask(std::int64_t now, std::int64_t /*until*/, std::vector<Event>& events) {
  now_ = now;
  server_.poll();
  strokes_.ask(now, events);
  std::ranges::move(events_, std::back_inserter(events));
  events_.clear();
}

}  // namespace idiophone::drivers
