#pragma once

namespace idiophone::playing {

inline constexpr int rate = 48000;  ///< of the sound in these tests, 1/s

}  // namespace idiophone::playing
