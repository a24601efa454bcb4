// stat() and access() of this program, which gmsh calls instead of the system's.

#include "visible_files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <memory>
#include <string>

namespace {

std::string visible;  // the folder with a slash at its end; empty: all

using RealPath = std::unique_ptr<char, void (*)(void*)>;

RealPath real_path(const char* path) {
  return {::realpath(path, nullptr), std::free};
}

bool is_visible(const char* path) {
  if (visible.empty()) {
    return true;
  }
  const RealPath real = real_path(path);
  return real && (std::string(real.get()) + "/").starts_with(visible);
}

}  // namespace

extern "C" [[gnu::visibility("default")]] int stat(const char* path, struct stat* state) noexcept {
  if (!is_visible(path)) {
    errno = ENOENT;
    return -1;
  }
  return ::fstatat(AT_FDCWD, path, state, 0);
}

extern "C" [[gnu::visibility("default")]] int access(const char* path, int mode) noexcept {
  if (!is_visible(path)) {
    errno = ENOENT;
    return -1;
  }
  return ::faccessat(AT_FDCWD, path, mode, 0);
}

namespace idiophone::mesher {

void show_only(const std::filesystem::path& folder) {
  const RealPath real = real_path(folder.c_str());
  visible = real ? std::string(real.get()) + "/" : "/nowhere/";
}

}  // namespace idiophone::mesher
