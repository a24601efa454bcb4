#include <fmt/format.h>
#include <smf.h>

#include <stdexcept>

#include "idiophone/playing/midi.hpp"

namespace idiophone::playing {

std::vector<Note> read_midi_file(const std::filesystem::path& file) {
  const std::unique_ptr<smf_t, void (*)(smf_t*)> midi(smf_load(file.c_str()), &smf_delete);
  if (!midi) {
    throw std::runtime_error(fmt::format("{}: can't be read as a MIDI file", file.string()));
  }
  std::vector<Note> notes;
  smf_rewind(midi.get());
  while (smf_event_t* event = smf_get_next_event(midi.get())) {
    constexpr int note_on = 0x90;
    if (event->midi_buffer_length == 3 && (event->midi_buffer[0] & 0xf0) == note_on && event->midi_buffer[2] > 0) {
      notes.push_back({event->time_seconds, event->midi_buffer[1] & 0x7f, event->midi_buffer[2] & 0x7f});
    }
  }
  return notes;
}

}  // namespace idiophone::playing
