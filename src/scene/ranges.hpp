#pragma once
// Ranges that several sections share: wide enough for anything that sounds, narrow enough that squares do not overflow.

#include "values.hpp"

namespace idiophone::scene {

constexpr Range coordinate{.at_least = -1e6, .at_most = 1e6, .unit = "m"};
constexpr Range force_component{.at_least = -1e12, .at_most = 1e12, .unit = "N"};
constexpr Range positive_seconds{.above = 0.0, .at_most = 1e6, .unit = "s"};

}  // namespace idiophone::scene
