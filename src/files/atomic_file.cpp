#include "idiophone/files/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace idiophone::files {

namespace {

[[noreturn]] void fail(const char* action, const std::filesystem::path& path, int error) {
  throw std::runtime_error(
      fmt::format("can't {} {}: {}", action, path.string(), std::system_category().message(error)));
}

}  // namespace

void synchronise(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);  // NOLINT(*-vararg): POSIX
  if (file < 0) {
    fail("open", path, errno);
  }
  const int status = ::fsync(file);
  const int error = errno;
  ::close(file);
  if (status != 0) {
    fail("write", path, error);
  }
}

void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  if (error) {
    fail("rename a file to", to, error.value());
  }
  synchronise(to.has_parent_path() ? to.parent_path() : ".");
}

void write_atomically(const std::filesystem::path& path, const std::string& text) {
  auto part = path;
  part += ".part";
  errno = 0;
  std::ofstream file(part, std::ios::binary);
  file << text;
  file.close();
  if (!file) {
    fail("write", part, errno);
  }
  synchronise(part);
  rename_durably(part, path);
}

}  // namespace idiophone::files
