#include "memory_limit.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <new>
#include <string>

#include "idiophone/foundation/signal_safe.hpp"
#include "idiophone/run/loop/stop.hpp"

namespace idiophone::app {

namespace {

constexpr std::array crashes = {SIGSEGV, SIGBUS, SIGABRT};
std::array<struct sigaction, crashes.size()> handlers_before{};

std::string& words_without_memory() {
  static std::string text;  // made in time: later there is no memory for it
  return text;
}

[[noreturn]] void end_for_want_of_memory() {
  write_to_stderr(words_without_memory());
  ::_exit(loop::exit_failed);
}

/// A failed allocation leaves its mark in errno. Other crashes go to the handler before this one.
extern "C" void judge_crash(int signal) {
  if (errno == ENOMEM) {
    end_for_want_of_memory();
  }
  for (std::size_t i = 0; i < crashes.size(); ++i) {
    ::sigaction(crashes[i], &handlers_before[i], nullptr);
  }
  if (signal == SIGABRT) {
    ::raise(signal);  // the others come again by themselves
  }
}

}  // namespace

void end_without_memory(int rank) {
  words_without_memory() =
      fmt::format("idiophone: rank {}: not enough memory (idiophone check DECK prints how much a run needs)\n", rank);
  std::set_new_handler(end_for_want_of_memory);
  struct sigaction action {};
  action.sa_handler = judge_crash;  // NOLINT(*-union-access): POSIX
  for (std::size_t i = 0; i < crashes.size(); ++i) {
    ::sigaction(crashes[i], &action, &handlers_before[i]);
  }
}

}  // namespace idiophone::app
