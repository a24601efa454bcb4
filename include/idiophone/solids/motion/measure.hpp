#pragma once
// What is known of a body's motion at one moment, as sums that come out the same to the bit on any number of ranks.

#include <vector>

#include "idiophone/solids/motion/body_sums.hpp"
#include "idiophone/solids/motion/initial_state.hpp"
#include "idiophone/solids/motion/motion.hpp"

namespace idiophone::motion {

/// Measures every body and every piece now; costs one force evaluation and changes nothing in the motion. No
/// communication.
/// @return [bodies], then [InitialState::pieces]
[[nodiscard]] std::vector<BodySums> measure(Motion& motion, const InitialState& initial_state);

}  // namespace idiophone::motion
