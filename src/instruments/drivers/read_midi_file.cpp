#include <fmt/format.h>
#include <smf.h>
#include <sys/wait.h>
#include <unistd.h>

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

}  // namespace

std::vector<Note> read_midi_file(const std::filesystem::path& file) {
  const std::unique_ptr<smf_t, void (*)(smf_t*)> midi(is_readable(file) ? smf_load(file.c_str()) : nullptr,
                                                      &smf_delete);
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

}  // namespace idiophone::drivers
