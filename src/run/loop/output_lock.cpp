#include "idiophone/run/loop/output_lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <ctime>
#include <fstream>
#include <iterator>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/errors.hpp"

namespace idiophone::loop {

namespace {

[[noreturn]] void fail(const std::string& action, const std::filesystem::path& path, int error) {
  throw std::runtime_error(
      fmt::format("can't {} {}: {}", action, path.string(), std::system_category().message(error)));
}

int open_lock(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);  // NOLINT(*-vararg): POSIX
  if (file < 0) {
    fail("open", path, errno);
  }
  return file;
}

/// @return 0, or the system's reason
int try_lock(int file) {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  return ::fcntl(file, F_SETLK, &whole) == 0 ? 0 : errno;  // NOLINT(*-vararg): POSIX
}

/// Whether the path still names the open file: its last holder removes it.
bool names(const std::filesystem::path& path, int file) {
  struct stat by_path {};
  struct stat by_file {};
  return ::stat(path.c_str(), &by_path) == 0 && ::fstat(file, &by_file) == 0 && by_path.st_ino == by_file.st_ino &&
         by_path.st_dev == by_file.st_dev;
}

std::string host_name() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return host.data();
}

std::string holder(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string text;
  return std::getline(file, text) && !text.empty() ? text : "a process that has not said which yet";
}

/// @return what it wrote; empty if it could not
std::string write_holder(int file) {
  auto text = fmt::format("process {} on {} since {:%Y-%m-%d %H:%M:%S} UTC", ::getpid(), host_name(),
                          fmt::gmtime(std::time(nullptr)));
  const std::string line = text + "\n";
  const bool is_written = ::ftruncate(file, 0) == 0 &&
                          ::pwrite(file, line.data(), line.size(), 0) == static_cast<ssize_t>(line.size()) &&
                          ::fsync(file) == 0;
  return is_written ? text : std::string();
}

/// Whether this rank reads the text of the lock that rank 0 holds. A network file system may show it late.
bool sees(const std::filesystem::path& path, const std::string& text) {
  constexpr int attempts = 50;
  for (int attempt = 0; attempt < attempts && holder(path) != text; ++attempt) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return holder(path) == text;
}

}  // namespace

OutputLock::OutputLock(std::filesystem::path directory, const std::string& name, MPI_Comm communicator)
    : directory_(std::move(directory)), path_(directory_ / (name + ".lock")) {
  parallel::on_root(communicator, [&] {
    made_directory_ = std::filesystem::create_directories(directory_);
    take();
    keeper_ = std::jthread([this](const std::stop_token& stop) { keep(stop); });
  });
  try {
    require_one_folder(communicator);
  } catch (...) {
    release();  // no destructor follows
    throw;
  }
}

void OutputLock::require_one_folder(MPI_Comm communicator) const {
  const std::string text = parallel::from_root(holder_, communicator);
  const bool is_seen = file_ >= 0 || sees(path_, text);
  parallel::agree(communicator,
                  is_seen ? std::string()
                          : fmt::format("rank {} on {} does not see {}, which rank 0 ({}) has made: all ranks write "
                                        "into one --output-folder, so it must lie on a file system that all machines "
                                        "of the job share, at the same path",
                                        parallel::rank_of(communicator), host_name(), path_.string(), text));
}

void OutputLock::take() {
  while (true) {
    file_ = open_lock(path_);
    const int error = try_lock(file_);
    if (error == EACCES || error == EAGAIN) {
      const std::string who = holder(path_);
      ::close(file_);
      throw std::runtime_error(fmt::format(
          "another run writes the same files: {} is held by {}; wait for its end, or give another --output-folder "
          "or another name in the deck",
          path_.string(), who));
    }
    if (error != 0) {
      spdlog::warn("can't lock {} ({}): nothing stops another run from writing the same files", path_.string(),
                   std::system_category().message(error));
    }
    if (names(path_, file_)) {
      break;
    }
    ::close(file_);
  }
  holder_ = write_holder(file_);
  if (holder_.empty()) {
    fail("write", path_, errno);
  }
}

void OutputLock::keep(const std::stop_token& stop) {
  constexpr auto interval = std::chrono::seconds(1);
  std::mutex mutex;
  std::unique_lock<std::mutex> guard(mutex);
  std::condition_variable_any sleep;
  while (!sleep.wait_for(guard, stop, interval, [&] { return stop.stop_requested(); })) {
    if (names(path_, file_)) {
      continue;
    }
    const int renewed = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);  // NOLINT(*-vararg): POSIX
    if (renewed >= 0 && try_lock(renewed) == 0 && names(path_, renewed)) {
      ::close(std::exchange(file_, renewed));
      static_cast<void>(write_holder(file_));  // the lock holds without
      spdlog::warn("{} was removed while this run holds it; it is there again", path_.string());
    } else if (renewed >= 0) {
      ::close(renewed);  // another run was quicker
    }
  }
}

OutputLock::~OutputLock() {
  release();
}

void OutputLock::release() {
  if (file_ < 0) {
    return;
  }
  keeper_ = {};
  std::error_code ignored;  // a lock's file that stays is locked by nobody
  if (names(path_, file_)) {
    std::filesystem::remove(path_, ignored);  // before it is unlocked, so that nobody locks a file that then goes
  }
  ::close(file_);
  if (made_directory_) {
    std::filesystem::remove(directory_, ignored);  // succeeds only if it is empty
  }
}

}  // namespace idiophone::loop
