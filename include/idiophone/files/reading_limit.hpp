#pragma once
// A limit for reading: in a damaged file of an old format, HDF5 can loop forever or overflow the stack.

#include <array>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <vector>

namespace idiophone::files {

/// During its lifetime this process may use 5 s of processor time and another second for each 20 MB of the file. After
/// that, or if reading crashes, the program ends with a message and status 1.
class ReadingLimit {
 public:
  /// @param least_seconds  for a file of no bytes
  explicit ReadingLimit(const std::filesystem::path& file, double least_seconds = 5.0);
  ReadingLimit(const ReadingLimit&) = delete;
  ReadingLimit& operator=(const ReadingLimit&) = delete;
  ReadingLimit(ReadingLimit&&) = delete;
  ReadingLimit& operator=(ReadingLimit&&) = delete;
  ~ReadingLimit();

 private:
  static constexpr std::array signals = {SIGVTALRM, SIGSEGV, SIGBUS};

  timer_t timer_{};
  bool has_timer_ = false;
  std::vector<char> stack_;  ///< of the signal handler: the other one may be full
  stack_t stack_before_{};
  std::array<struct sigaction, signals.size()> before_{};
};

}  // namespace idiophone::files
