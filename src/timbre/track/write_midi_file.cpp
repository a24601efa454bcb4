#include <fmt/format.h>
#include <smf.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <utility>

#include "music.hpp"

namespace idiophone::timbre {

namespace {

void add_event(smf_track_t* track, double time, std::array<unsigned char, 3> bytes, int count) {
  smf_event_t* event = smf_event_new_from_pointer(bytes.data(), count);
  if (event == nullptr) {
    throw std::runtime_error("libsmf refuses a MIDI event");
  }
  smf_track_add_event_seconds(track, event, time);
}

void add_part(smf_track_t* track, const ScorePart& part, const MusicScore& score, int channel) {
  constexpr int name_of_track = 3;
  smf_track_add_event_seconds(track, smf_event_new_textual(name_of_track, part.name.c_str()), 0.0);
  const auto status = [channel](int kind) { return static_cast<unsigned char>(kind | channel); };
  const auto data = [](int number) { return static_cast<unsigned char>(number); };
  int program = -1;
  for (const ScoreNote& note : part.notes) {
    const double start = note.start * score.every;
    if (note.program != std::exchange(program, note.program)) {
      add_event(track, start, {status(0xc0), data(note.program), 0}, 2);
    }
    add_event(track, start, {status(0x90), data(note.number), data(note.velocity)}, 3);
    const double end = std::min((note.start + note.length) * score.every, score.duration);
    add_event(track, end, {status(0x80), data(note.number), 0}, 3);
  }
}

}  // namespace

void write_midi(const std::filesystem::path& file, const MusicScore& score) {
  const std::unique_ptr<smf_t, void (*)(smf_t*)> midi(smf_new(), &smf_delete);
  constexpr int ticks_of_quarter = 480;  // at 120 quarters a minute, about a millisecond
  constexpr int drums = 9;
  if (smf_set_ppqn(midi.get(), ticks_of_quarter) != 0) {
    throw std::runtime_error("libsmf refuses the resolution");
  }
  int channel = 0;
  for (const ScorePart& part : score.parts) {
    smf_track_t* track = smf_track_new();
    smf_add_track(midi.get(), track);
    add_part(track, part, score, channel);
    channel += channel + 1 == drums ? 2 : 1;
  }
  if (smf_save(midi.get(), file.c_str()) != 0) {
    throw std::runtime_error(fmt::format("{}: can't be written", file.string()));
  }
}

}  // namespace idiophone::timbre
