#include "reading_limit.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <string>
#include <system_error>

namespace idiophone::store {

namespace {

constexpr double least_seconds = 5.0, bytes_per_second = 20e6;

std::string& message() {
  static std::string text;
  return text;
}

/// Only what may be called in a signal handler.
extern "C" void end_program(int /*signal*/) {
  static_cast<void>(!::write(STDERR_FILENO, message().data(), message().size()));
  ::_exit(1);
}

double seconds_for(const std::filesystem::path& file) {
  std::error_code ignored;  // a file that is not there is read in no time
  const auto bytes = std::filesystem::file_size(file, ignored);
  return least_seconds + (ignored ? 0.0 : static_cast<double>(bytes) / bytes_per_second);
}

}  // namespace

ReadingLimit::ReadingLimit(const std::filesystem::path& file) {
  const double seconds = seconds_for(file);
  message() = fmt::format("error: {} is damaged: reading it did not end within {:.0f} s of computing\n", file.string(),
                          seconds);
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGXCPU;
  armed_ = ::timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer_) == 0;
  if (armed_) {
    struct sigaction action {};
    action.sa_handler = end_program;  // NOLINT(*-union-access): POSIX
    ::sigaction(SIGXCPU, &action, &before_);
    const itimerspec once{{}, {static_cast<time_t>(seconds), 0}};
    ::timer_settime(timer_, 0, &once, nullptr);
  }
}

ReadingLimit::~ReadingLimit() {
  if (armed_) {
    ::timer_delete(timer_);
    ::sigaction(SIGXCPU, &before_, nullptr);
  }
}

}  // namespace idiophone::store
