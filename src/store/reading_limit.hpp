#pragma once
// A bound on reading: HDF5 can search a damaged file of an old format for ever.

#include <csignal>
#include <ctime>
#include <filesystem>

namespace idiophone::store {

/// While it lives, this process may compute for 5 s and another second for each 20 MB of the file. Then the program
/// ends with a message and status 1. Waiting for disks does not count.
class ReadingLimit {
 public:
  explicit ReadingLimit(const std::filesystem::path& file);
  ReadingLimit(const ReadingLimit&) = delete;
  ReadingLimit& operator=(const ReadingLimit&) = delete;
  ReadingLimit(ReadingLimit&&) = delete;
  ReadingLimit& operator=(ReadingLimit&&) = delete;
  ~ReadingLimit();

 private:
  timer_t timer_{};
  bool armed_ = false;
  struct sigaction before_ {};
};

}  // namespace idiophone::store
