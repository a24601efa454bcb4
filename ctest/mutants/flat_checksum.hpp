#pragma once
// Flat files whose contents are wrong and whose checksum is right.

#include <cstdint>
#include <span>
#include <string>

#include "idiophone/foundation/flat_file.hpp"

namespace idiophone::mutants {

/// The bytes of a flat file with the checksum of its contents, so that a reader looks at these.
inline std::string with_right_checksum(std::string bytes) {
  constexpr std::size_t sum = 20, contents = 28;  // where they begin
  if (bytes.size() > contents) {
    const std::uint64_t right = flat_checksum(std::span(bytes).subspan(contents));
    for (std::size_t i = 0; i < sizeof(right); ++i) {
      bytes[sum + i] = static_cast<char>(right >> (8U * i));
    }
  }
  return bytes;
}

}  // namespace idiophone::mutants
