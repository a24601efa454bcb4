#include "playing_drivers.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "idiophone/instruments/drivers/players.hpp"
#include "idiophone/instruments/drivers/score_notes.hpp"
#include "idiophone/instruments/outputs/midi_output.hpp"
#include "idiophone/run/loop/stop.hpp"

namespace idiophone::timbre {

namespace {

/// Without a score and a deck, the sound ends when the last contact was heard for a second.
double duration_of(const std::vector<drivers::Event>& contacts, int rate) {
  std::int64_t last = 0;
  for (const drivers::Event& event : contacts) {
    last = std::max(last, event.start);
  }
  return static_cast<double>(last) / rate + 1.0;
}

}  // namespace

drivers::Drivers known_drivers(const PlaySettings& settings, score::Score& score,
                               const std::vector<drivers::StruckBody>& bodies, int rate) {
  drivers::Drivers drivers;
  drivers.push_back(std::make_unique<drivers::ScoreDriver>(score.events, score.seed, rate));
  if (!settings.midi.empty() && settings.midi != jack_as_midi) {
    if (std::ranges::any_of(score.notes, [](const score::NoteAction& note) { return !note.strikes(); })) {
      throw std::runtime_error("notes that scrape, roll or bow need a player, --midi jack; a MIDI file has blows only");
    }
    drivers::NoteBlows blows = drivers::blows_of(drivers::read_midi_file(settings.midi), score.notes);
    if (blows.unknown > 0) {
      spdlog::warn("{}: {} notes that the score has nothing for", settings.midi, blows.unknown);
    }
    drivers.push_back(std::make_unique<drivers::ScoreDriver>(std::move(blows.events), score.seed, rate));
  }
  if (!settings.contacts.empty()) {
    std::vector<drivers::Event> contacts = drivers::contact_events(settings.contacts, bodies, rate);
    score.duration = score.duration > 0.0 ? score.duration : duration_of(contacts, rate);
    drivers.push_back(std::make_unique<drivers::KnownEvents>(std::move(contacts)));
  }
  if (!settings.motion.empty()) {
    drivers.push_back(
        std::make_unique<drivers::KnownEvents>(drivers::motion_events(settings.motion, score.motion, rate)));
  }
  return drivers;
}

void add_players(const PlaySettings& settings, const score::Score& score, const voices::Stage& stage,
                 drivers::Drivers& drivers) {
  if (settings.midi == jack_as_midi) {
    drivers.push_back(std::make_unique<drivers::MidiPlayer>(score.notes, score.seed, stage.rate(), stage.lead()));
  }
  if (settings.osc) {
    drivers.push_back(std::make_unique<drivers::OscPlayer>(settings.osc_address, *settings.osc, stage.bodies(),
                                                           score.seed, stage.rate(), stage.lead()));
  }
}

std::size_t send_notes(const PlaySettings& settings, const score::Score& score) {
  const drivers::ScoreNotes found = drivers::notes_of(score.events, score.notes);
  if (found.left_out > 0) {
    spdlog::warn("--midi-out leaves out {} events: they are no blows, or no note of the score strikes their body",
                 found.left_out);
  }
  std::vector<outputs::MidiMessage> messages = drivers::messages_of(found.notes);
  if (!settings.midi.empty()) {
    const std::vector<outputs::MidiMessage> file = drivers::read_midi_messages(settings.midi);
    messages.insert(messages.end(), file.begin(), file.end());
    std::ranges::stable_sort(messages, {}, &outputs::MidiMessage::time);
  }
  if (messages.empty()) {
    throw std::runtime_error("--midi-out: neither the score nor a MIDI file has a note");
  }
  const std::size_t count = messages.size();
  loop::watch_signals(loop::OnSignal::note);
  outputs::play_midi(std::move(messages), settings.midi_out == jack_as_midi ? "" : settings.midi_out,
                     [] { return loop::noted_signal() != 0; });
  return count;
}

}  // namespace idiophone::timbre
