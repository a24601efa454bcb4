#pragma once
// Bytes as text, for glTF files and web pages.

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace idiophone::web {

/// Base64 with padding, RFC 4648.
[[nodiscard]] inline std::string base64(std::span<const std::byte> bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(4 * ((bytes.size() + 2) / 3));
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned three = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      three = three << 8U | (i + k < bytes.size() ? std::to_integer<unsigned>(bytes[i + k]) : 0U);
    }
    const std::size_t left = std::min<std::size_t>(bytes.size() - i, 3);
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= left ? digits[three >> (18U - 6U * k) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace idiophone::web
