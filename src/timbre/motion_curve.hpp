#pragma once
// Motion channels as curves.

#include <memory>

#include "curve.hpp"
#include "idiophone/timbre/motion_channels.hpp"

namespace idiophone::timbre {

/// A channel over time, with the interpolation of the variable. @throws as MotionChannels::values()
[[nodiscard]] std::shared_ptr<const Curve> curve_of(const scene::MotionVariable& variable,
                                                    const MotionChannels& motion);

}  // namespace idiophone::timbre
