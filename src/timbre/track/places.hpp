#pragma once
// Where the sounds and the objects of a sonic scene are, and how they turn.

#include <Eigen/Core>
#include <functional>

#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"
#include "idiophone/timbre/track/motion_channels.hpp"

namespace idiophone::timbre {

/// The place at a time (s), m; empty for a sound without one.
/// @throws deck::DeckError if the run does not have the body
[[nodiscard]] std::function<Vector3(double time)> path_of(const SonicPlace& place, const deck::Location& where,
                                                          const MotionChannels& motion);

/// The rotation of a body since the undeformed one at a time (s); the identity without a body.
/// @throws deck::DeckError if the run does not have the body
[[nodiscard]] std::function<Eigen::Matrix3d(double time)> turn_of(const SonicPlace& place, const deck::Location& where,
                                                                  const MotionChannels& motion);

}  // namespace idiophone::timbre
