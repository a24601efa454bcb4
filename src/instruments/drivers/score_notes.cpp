#include "idiophone/instruments/drivers/score_notes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace idiophone::drivers {

namespace {

/// Null if no note strikes the body.
const score::NoteAction* nearest_action(const score::HammerBlow& blow, std::size_t body,
                                        const std::vector<score::NoteAction>& actions) {
  const score::NoteAction* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const score::NoteAction& action : actions) {
    const double distance = (action.blow.at - blow.at).norm();
    if (action.body == body && action.strikes() && distance < least) {
      nearest = &action;
      least = distance;
    }
  }
  return nearest;
}

outputs::MidiMessage message_of(int kind, const Note& note, double time) {
  return {.time = time,
          .bytes = {static_cast<unsigned char>(kind), static_cast<unsigned char>(note.number),
                    static_cast<unsigned char>(note.velocity)}};
}

}  // namespace

ScoreNotes notes_of(const std::vector<score::ScoreEvent>& events, const std::vector<score::NoteAction>& actions) {
  constexpr double loudest = 127.0;
  ScoreNotes found;
  for (const score::ScoreEvent& event : events) {
    const auto* blow = std::get_if<score::HammerBlow>(&event.action);
    const score::NoteAction* action = blow == nullptr ? nullptr : nearest_action(*blow, event.body, actions);
    if (action == nullptr) {
      ++found.left_out;
      continue;
    }
    const double velocity = loudest * blow->hammer.speed / action->blow.hammer.speed;
    found.notes.push_back(
        {event.time, action->note, static_cast<int>(std::lround(std::clamp(velocity, 1.0, loudest)))});
  }
  std::ranges::stable_sort(found.notes, {}, &Note::time);
  return found;
}

std::vector<outputs::MidiMessage> messages_of(const std::vector<Note>& notes) {
  constexpr int note_on = 0x90, note_off = 0x80;
  constexpr double length = 0.25;  // s
  std::vector<outputs::MidiMessage> messages;
  std::map<int, double> next;  // when a note is struck again, by its number
  for (auto note = notes.rbegin(); note != notes.rend(); ++note) {
    const auto again = next.find(note->number);
    const double end = note->time + length;
    messages.push_back(message_of(note_off, *note, again == next.end() ? end : std::min(end, again->second)));
    messages.push_back(message_of(note_on, *note, note->time));
    next[note->number] = note->time;
  }
  std::ranges::reverse(messages);
  // A note that ends when it is struck again ends first.
  std::ranges::stable_sort(messages, [](const outputs::MidiMessage& a, const outputs::MidiMessage& b) {
    return a.time < b.time || (a.time == b.time && a.bytes[0] < b.bytes[0]);
  });
  return messages;
}

}  // namespace idiophone::drivers
