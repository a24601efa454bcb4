#include "idiophone/instruments/drivers/midi_actions.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "blow_of_note.hpp"

namespace idiophone::drivers {

MidiActions::MidiActions(std::vector<score::NoteAction> actions, std::uint64_t seed, int rate, std::int64_t lead)
    : actions_(std::move(actions)), rate_(rate), strokes_(seed, rate, lead), budget_(rate) {}

void MidiActions::take(const MidiMessage& message, std::int64_t now, std::vector<Event>& events) {
  constexpr double most = 127.0, most_bend = 8192.0;
  switch (message.kind) {
    case MidiMessage::Kind::press:
      return press(message, now, events);
    case MidiMessage::Kind::release:
      return release(message.number);
    case MidiMessage::Kind::pressure:
      for (auto& [number, held] : held_) {
        held.load = held.whole_load * message.value / most;
      }
      return lead();
    case MidiMessage::Kind::bend:
      faster_ = std::pow(4.0, message.value / most_bend);
      return lead();
  }
}

void MidiActions::press(const MidiMessage& message, std::int64_t now, std::vector<Event>& events) {
  const Note note{.number = message.number, .velocity = message.value};
  const score::NoteAction* action = action_of(note, actions_);
  if (action == nullptr) {
    ++unknown_;
  } else if (action->strikes()) {
    const score::ScoreEvent blow = blow_of(note, *action);
    budget_.take(blow, now);
    events.push_back(event_of(blow, now, 0, rate_));
    events.back().sent = steady_clock();
  } else {
    release(note.number);
    begin(note, *action, now);
  }
}

void MidiActions::begin(const Note& note, const score::NoteAction& action, std::int64_t now) {
  const std::string name = std::to_string(note.number);
  const double share = note.velocity / 127.0;
  if (action.stroke) {
    score::Stroke begun = *action.stroke;
    begun.load *= share;
    begun.speed *= faster_;
    strokes_.begin(name, action.body, begun, now);
    held_[note.number] = {action.stroke->speed, action.stroke->load, begun.load};
  } else {
    score::Bow begun = *action.bow;
    begun.load.scale(share);
    begun.speed.scale(faster_);
    strokes_.begin(name, action.body, begun, now);
    held_[note.number] = {action.bow->speed.last(), action.bow->load.last(), begun.load.last()};
  }
}

void MidiActions::release(int number) {
  if (held_.erase(number) > 0) {
    strokes_.end(std::to_string(number));
  }
}

void MidiActions::lead() {
  for (const auto& [number, held] : held_) {
    strokes_.change(std::to_string(number), faster_ * held.speed, held.load);
  }
}

}  // namespace idiophone::drivers
