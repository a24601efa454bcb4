#pragma once
// Text of files and users on a terminal: characters that steer the terminal, or change the direction of what is shown,
// become visible.

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace idiophone {

/// The character that a text begins with.
struct Character {
  char32_t code = 0;
  std::size_t bytes = 1;
  bool is_utf8 = true;  ///< otherwise `code` is the value of one byte
};

/// @param text  not empty
[[nodiscard]] inline Character first_character(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const auto first = byte(0);
  const std::size_t bytes = first < 0x80   ? 1
                            : first < 0xc2 ? 0
                            : first < 0xe0 ? 2
                            : first < 0xf0 ? 3
                            : first < 0xf5 ? 4
                                           : 0;
  if (bytes == 0 || bytes > text.size()) {
    return {.code = first, .is_utf8 = false};
  }
  char32_t code = bytes == 1 ? first : first & (0x7fU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) {
      return {.code = first, .is_utf8 = false};
    }
    code = code << 6U | (byte(i) & 0x3fU);
  }
  const bool is_too_long = (bytes == 3 && code < 0x800) || (bytes == 4 && (code < 0x10000 || code > 0x10ffff));
  const bool is_surrogate = code >= 0xd800 && code < 0xe000;
  return is_too_long || is_surrogate ? Character{.code = first, .is_utf8 = false}
                                     : Character{.code = code, .bytes = bytes};
}

/// Whether a character steers a terminal (C0 and C1 but for tabs and line feeds), or the direction of text.
[[nodiscard]] inline bool is_control(char32_t code) {
  const auto within = [code](char32_t first, char32_t last) { return code >= first && code <= last; };
  return (within(0, 0x1f) && code != U'\n' && code != U'\t') || within(0x7f, 0x9f) || code == 0x61c ||
         within(0x200e, 0x200f) || within(0x2028, 0x202e) || within(0x2066, 0x2069);
}

/// The text with "\x1b" or "\u202e" for such characters, and "\xe9" for bytes that are not UTF-8.
[[nodiscard]] inline std::string for_terminal(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const Character next = first_character(text);
    if (next.is_utf8 && !is_control(next.code)) {
      shown += text.substr(0, next.bytes);
    } else {
      const auto code = static_cast<unsigned>(next.code);
      shown += code < 0x100 ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
    }
    text.remove_prefix(next.bytes);
  }
  return shown;
}

}  // namespace idiophone
