#pragma once
// Motion channels as curves.

#include <memory>

#include "idiophone/timbre/nodes/curve.hpp"
#include "idiophone/timbre/track/motion_channels.hpp"

namespace idiophone::timbre {

/// A channel over time, with the interpolation of the variable. @throws as MotionChannels::values()
[[nodiscard]] std::shared_ptr<const Curve> curve_of(const timbre::MotionVariable& variable,
                                                    const MotionChannels& motion);

}  // namespace idiophone::timbre
