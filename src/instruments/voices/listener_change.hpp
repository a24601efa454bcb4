#pragma once
// How long the listener takes to a new place.

#include <cstdint>

namespace idiophone::voices {

inline constexpr std::int64_t change_length = 1024;  ///< audio samples, of a piece of the listener's path

}  // namespace idiophone::voices
