#pragma once

namespace idiophone::resonators {

inline constexpr int rate = 48000;  ///< of the sound in these tests, 1/s

}  // namespace idiophone::resonators
