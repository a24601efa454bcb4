#include "stop.hpp"

#include <csignal>
#include <initializer_list>

namespace idiophone::app {

namespace {

volatile std::sig_atomic_t signal_noted = 0;

extern "C" void note_signal(int signal) {
  signal_noted = signal;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void watch_signals() {
  for (const int signal : {SIGTERM, SIGINT, SIGUSR1}) {
    std::signal(signal, note_signal);
  }
}

int noted_signal() {
  return signal_noted;
}

}  // namespace idiophone::app
