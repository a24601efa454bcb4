#include "idiophone/instruments/drivers/players.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <utility>

namespace idiophone::drivers {

namespace {

constexpr std::int64_t stroke_lead = 512;  // audio samples by which a stroke begins later, so that all of it is there

std::int64_t steady_clock() {
  return std::chrono::steady_clock::now().time_since_epoch().count();
}

/// What a note does, if anything.
std::optional<score::ScoreEvent> blow_of(const Note& note, const std::vector<score::NoteAction>& actions) {
  const auto found = std::ranges::find(actions, note.number, &score::NoteAction::note);
  if (found == actions.end()) {
    return {};
  }
  score::HammerBlow blow = found->blow;
  blow.hammer.speed *= note.velocity / 127.0;
  return score::ScoreEvent{note.time, found->body, blow};
}

}  // namespace

NoteBlows blows_of(const std::vector<Note>& notes, const std::vector<score::NoteAction>& actions) {
  NoteBlows blows;
  for (const Note& note : notes) {
    if (const std::optional<score::ScoreEvent> event = blow_of(note, actions)) {
      blows.events.push_back(*event);
    } else {
      ++blows.unknown;
    }
  }
  return blows;
}

MidiPlayer::MidiPlayer(std::vector<score::NoteAction> actions, int rate) : actions_(std::move(actions)), rate_(rate) {}

void MidiPlayer::ask(std::int64_t now, std::int64_t /*until*/, std::vector<Event>& events) {
  for (Note note; midi_.take(note);) {
    const std::int64_t sent = steady_clock();
    if (const std::optional<score::ScoreEvent> event = blow_of(note, actions_)) {
      events.push_back(event_of(*event, now, 0, rate_));
      events.back().sent = sent;
    } else {
      ++unknown_;
    }
  }
}

std::string MidiPlayer::complaint() const {
  return unknown_ > 0 ? fmt::format("{} MIDI notes that the score has nothing for", unknown_) : "";
}

OscPlayer::OscPlayer(int port, std::vector<std::string> bodies, std::uint64_t seed, int rate)
    : seed_(seed),
      rate_(rate),
      server_(port, std::move(bodies),
              {.play = [this](const score::ScoreEvent& event) { play(event); },
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
  std::ranges::move(events_, std::back_inserter(events));
  events_.clear();
}

}  // namespace idiophone::drivers
