#include "stop.hpp"

#include <unistd.h>

#include <csignal>
#include <initializer_list>
#include <string_view>

namespace idiophone::app {

namespace {

volatile std::sig_atomic_t signal_noted = 0;

extern "C" void note_signal(int signal) {
  signal_noted = signal;
  std::signal(signal, SIG_DFL);
}

/// Calls nothing that a signal handler must not call. idiophone_gmsh ends with its parent.
extern "C" void end_by_signal(int /*signal*/) {
  constexpr std::string_view message = "stopped by a signal before there was anything to save\n";
  static_cast<void>(!write(STDERR_FILENO, message.data(), message.size()));
  _exit(exit_resumable);
}

}  // namespace

void watch_signals(OnSignal action) {
  for (const int signal : {SIGTERM, SIGINT, SIGUSR1}) {
    std::signal(signal, action == OnSignal::end ? end_by_signal : note_signal);
  }
  if (action == OnSignal::end && signal_noted != 0) {
    end_by_signal(signal_noted);
  }
}

int noted_signal() {
  return signal_noted;
}

}  // namespace idiophone::app
