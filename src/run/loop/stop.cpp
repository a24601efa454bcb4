#include "idiophone/run/loop/stop.hpp"

#include <unistd.h>

#include <array>
#include <csignal>
#include <string_view>

#include "idiophone/foundation/signal_safe.hpp"

namespace idiophone::loop {

namespace {

constexpr std::array signals = {SIGTERM, SIGINT, SIGUSR1, SIGXCPU};
constexpr std::string_view nothing_saved = "stopped by a signal before there was anything to save\n";
constexpr std::string_view wavs_missing =
    "stopped by a signal while WAV files were written; the result has the whole sound\n";
constexpr std::string_view ended_by_launcher =
    "ended by the launcher, because another rank failed or the launcher was stopped\n";

std::array<struct sigaction, signals.size()> without_us{};  ///< what the signals do without us: SIG_DFL, or what a host
                                                            ///< has chosen
bool is_guest = false;
volatile std::sig_atomic_t signal_noted = 0;
volatile std::sig_atomic_t in_a_job = 0;  ///< several ranks under a launcher
volatile std::sig_atomic_t silent = 0;    ///< another rank of the job speaks
std::string_view last_words = nothing_saved;

// The handlers call nothing that a signal handler must not call.

extern "C" void note_signal(int signal) {
  signal_noted = signal;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    if (signals[i] == signal && signal != SIGXCPU) {  // the kernel repeats that one each second until the hard limit
      ::sigaction(signal, &without_us[i], nullptr);
    }
  }
}

/// idiophone_gmsh ends with its parent.
[[noreturn]] void end_saying(std::string_view message) {
  write_to_stderr(message);
  _exit(exit_resumable);
}

extern "C" void end_by_signal(int signal, siginfo_t* info, void* /*context*/) {
  const bool by_launcher = in_a_job != 0 && info->si_pid == getppid();
  if (by_launcher && silent != 0) {
    end_saying("");
  }
  end_saying(by_launcher && signal == SIGTERM ? ended_by_launcher : last_words);
}

}  // namespace

void watch_signals(OnSignal action) {
  if (is_guest) {
    return;
  }
  last_words = action == OnSignal::end_wavs ? wavs_missing : nothing_saved;
  for (const int signal : signals) {
    if (action == OnSignal::note) {
      std::signal(signal, note_signal);
    } else {
      struct sigaction ending = {};
      ending.sa_sigaction = end_by_signal;  // NOLINT(*-union-access): POSIX
      ending.sa_flags = SA_SIGINFO;
      ::sigaction(signal, &ending, nullptr);
    }
  }
  if (action != OnSignal::note && signal_noted != 0) {
    end_saying(last_words);
  }
}

void note_rank(int rank, int ranks) {
  in_a_job = ranks > 1 ? 1 : 0;
  silent = rank > 0 ? 1 : 0;
}

int noted_signal() {
  return signal_noted;
}

GuestSignals::GuestSignals() {
  signal_noted = 0;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    ::sigaction(signals[i], nullptr, &without_us[i]);
    std::signal(signals[i], note_signal);
  }
  is_guest = true;
}

GuestSignals::~GuestSignals() {
  is_guest = false;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    ::sigaction(signals[i], &without_us[i], nullptr);
    without_us[i] = {};
  }
  if (const int signal = take(); signal != 0 && signal != asked_by_host) {
    ::raise(signal);
  }
}

void GuestSignals::ask_to_stop() {
  signal_noted = asked_by_host;
}

int GuestSignals::take() {
  const int signal = signal_noted;
  signal_noted = 0;
  return signal;
}

}  // namespace idiophone::loop
