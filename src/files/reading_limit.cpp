#include "idiophone/files/reading_limit.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <string>
#include <system_error>

#include "idiophone/foundation/signal_safe.hpp"

namespace idiophone::files {

namespace {

constexpr double bytes_per_second = 20e6;
constexpr std::size_t stack_bytes = 64 << 10;

std::string& last_words() {
  static std::string text;
  return text;
}

/// Calls only functions that are safe in a signal handler.
extern "C" void end_reading(int /*signal*/) {
  write_to_stderr(last_words());
  ::_exit(1);
}

itimerspec once_after(double seconds) {
  const double whole = std::floor(seconds);
  return {.it_interval = {},
          .it_value = {.tv_sec = static_cast<time_t>(whole), .tv_nsec = static_cast<long>(1e9 * (seconds - whole))}};
}

}  // namespace

ReadingLimit::ReadingLimit(const std::filesystem::path& file, double least_seconds) : stack_(stack_bytes) {
  std::error_code ignored;  // a file that is not there is read in no time
  const auto bytes = std::filesystem::file_size(file, ignored);
  const double seconds = least_seconds + (ignored ? 0.0 : static_cast<double>(bytes) / bytes_per_second);
  last_words() = fmt::format("error: {} is damaged: reading it crashes, or does not end within {:.3g} s of computing\n",
                             file.string(), seconds);

  const stack_t stack{.ss_sp = stack_.data(), .ss_flags = 0, .ss_size = stack_.size()};
  ::sigaltstack(&stack, &stack_before_);
  struct sigaction action {};
  action.sa_handler = end_reading;  // NOLINT(*-union-access): POSIX
  action.sa_flags = SA_ONSTACK;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    ::sigaction(signals[i], &action, &before_[i]);
  }

  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGVTALRM;  // SIGXCPU belongs to the limit of the whole process
  has_timer_ = ::timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer_) == 0;
  if (has_timer_) {
    const itimerspec once = once_after(seconds);
    ::timer_settime(timer_, 0, &once, nullptr);
  }
}

ReadingLimit::~ReadingLimit() {
  if (has_timer_) {
    ::timer_delete(timer_);
  }
  for (std::size_t i = 0; i < signals.size(); ++i) {
    ::sigaction(signals[i], &before_[i], nullptr);
  }
  ::sigaltstack(&stack_before_, nullptr);
}

}  // namespace idiophone::files
