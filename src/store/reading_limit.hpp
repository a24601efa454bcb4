#pragma once
// A bound on reading: in a damaged file of an old format, HDF5 can search for ever or until its stack overflows.

#include <array>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <vector>

namespace idiophone::store {

/// While it lives, this process may compute for 5 s and another second for each 20 MB of the file; waiting for disks
/// does not count. After that, and if reading crashes, the program ends with a message and status 1.
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
  static constexpr std::array signals = {SIGXCPU, SIGSEGV, SIGBUS};

  timer_t timer_{};
  bool has_timer_ = false;
  std::vector<char> stack_;  ///< of the signal handler: the other one may be full
  stack_t stack_before_{};
  std::array<struct sigaction, signals.size()> before_{};
};

}  // namespace idiophone::store
