#pragma once
// Ranges that several sections share: wide enough for anything that sounds, narrow enough that squares do not overflow.

#include "idiophone/foundation/deck/values.hpp"
#include "idiophone/scene/limits.hpp"

namespace idiophone::scene {

constexpr deck::Range coordinate{.at_least = -farthest_coordinate, .at_most = farthest_coordinate, .unit = "m"};
constexpr deck::Range force_component{.at_least = -1e12, .at_most = 1e12, .unit = "N"};
constexpr deck::Range wall_thickness{.at_least = 1e-6, .at_most = 1.0, .unit = "m"};
constexpr deck::Range positive_seconds{.above = 0.0, .at_most = 1e6, .unit = "s"};

}  // namespace idiophone::scene
