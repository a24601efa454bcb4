#pragma once
// What a signal handler, or a process just before its end, may call.

#include <unistd.h>

#include <string_view>

namespace idiophone {

/// Writes to stderr without memory allocation or locks. What cannot be written is lost.
inline void write_to_stderr(std::string_view text) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace idiophone
