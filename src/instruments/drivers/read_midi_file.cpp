#include <fmt/format.h>
#include <smf.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <system_error>

#include "idiophone/instruments/drivers/midi.hpp"

namespace idiophone::drivers {

namespace {

/// Whether libsmf can read the file. A child process tries it, because assertions of libsmf end the process.
bool is_readable(const std::filesystem::path& file) {
  const pid_t child = ::fork();
  if (child < 0) {
    throw std::system_error(errno, std::generic_category(), "can't start a process that reads the MIDI file");
  }
  if (child == 0) {
    for (const int fatal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE}) {
      std::signal(fatal, SIG_DFL);
    }
    std::fclose(stderr);
    constexpr unsigned patience = 10;  // s
    ::alarm(patience);
    ::_exit(smf_load(file.c_str()) != nullptr ? 0 : 1);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) {
      throw std::system_error(errno, std::generic_category(), "can't wait for the process that reads the MIDI file");
    }
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Calls take(event) for all events, in the order of their times.
template <class Take>
void read_events(const std::filesystem::path& file, const Take& take) {
  const std::unique_ptr<smf_t, void (*)(smf_t*)> midi(is_readable(file) ? smf_load(file.c_str()) : nullptr,
                                                      &smf_delete);
  if (!midi) {
    throw std::runtime_error(fmt::format("{}: can't be read as a MIDI file", file.string()));
  }
  smf_rewind(midi.get());
  while (const smf_event_t* event = smf_get_next_event(midi.get())) {
    take(*event);
  }
}

}  // namespace

std::vector<Note> read_midi_file(const std::filesystem::path& file) {
  std::vector<Note> notes;
  read_events(file, [&](const smf_event_t& event) {
    constexpr int note_on = 0x90;
    if (event.midi_buffer_length == 3 && (event.midi_buffer[0] & 0xf0) == note_on && event.midi_buffer[2] > 0) {
      notes.push_back({event.time_seconds, event.midi_buffer[1] & 0x7f, event.midi_buffer[2] & 0x7f});
    }
  });
  return notes;
}

std::vector<outputs::MidiMessage> read_midi_messages(const std::filesystem::path& file) {
  std::vector<outputs::MidiMessage> messages;
  read_events(file, [&](const smf_event_t& event) {
    constexpr int system = 0xf0;  // and the names and tempos of the file
    outputs::MidiMessage message{.time = event.time_seconds};
    if (event.midi_buffer[0] < system && static_cast<std::size_t>(event.midi_buffer_length) <= message.bytes.size()) {
      message.count = static_cast<std::size_t>(event.midi_buffer_length);
      std::copy_n(event.midi_buffer, message.count, message.bytes.begin());
      messages.push_back(message);
    }
  });
  return messages;
}

}  // namespace idiophone::drivers
