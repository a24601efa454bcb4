#include "idiophone/instruments/drivers/players.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "blow_of_note.hpp"

namespace idiophone::drivers {

namespace {

constexpr std::int64_t stroke_lead = 512;  // audio samples by which a stroke begins later, so that all of it is there

}  // namespace

NoteBlows blows_of(const std::vector<Note>& notes, const std::vector<score::NoteAction>& actions) {
  NoteBlows blows;
  for (const Note& note : notes) {
    const score::NoteAction* action = action_of(note, actions);
    if (action != nullptr && !action->stroke) {
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
  for (MidiMessage message; midi_.take(message);) {
    try {
      actions_.take(message, now, events);
    } catch (const std::runtime_error& error) {
      spdlog::warn("MIDI note {}: {}", message.number, error.what());
    }
  }
  actions_.ask(now, events);
}

std::string MidiPlayer::complaint() const {
  return actions_.unknown() > 0 ? fmt::format("{} MIDI notes that the score has nothing for", actions_.unknown()) : "";
}

OscPlayer::OscPlayer(int port, std::vector<std::string> bodies, std::uint64_t seed, int rate, std::int64_t lead)
    : seed_(seed),
      rate_(rate),
      strokes_(seed, rate, lead),
      server_(port, std::move(bodies),
              {.play = [this](const score::ScoreEvent& event) { play(event); },
               .begin_stroke =
                   [this](const std::string& name, const score::ScoreEvent& event) {
                     strokes_.begin(name, event.body, std::get<score::Stroke>(event.action), now_);
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
  const bool moves = std::holds_alternative<score::Stroke>(event.action);
  events_.push_back(event_of(event, now_ + (moves ? stroke_lead : 0), seed_, rate_));
  events_.back().sent = sent;
}

void OscPlayer::ask(std::int64_t now, std::int64_t /*until*/, std::vector<Event>& events) {
  now_ = now;
  server_.poll();
  strokes_.ask(now, events);
  std::ranges::move(events_, std::back_inserter(events));
  events_.clear();
}

}  // namespace idiophone::drivers
