#pragma once
// Motion channels as curves, and what parameters of trees are bound to.

#include <memory>
#include <vector>

#include "idiophone/timbre/language/binding.hpp"
#include "idiophone/timbre/nodes/curve.hpp"
#include "idiophone/timbre/track/motion_channels.hpp"

namespace idiophone::timbre {

/// A channel over time, with the interpolation of the variable. @throws as MotionChannels::values()
[[nodiscard]] std::shared_ptr<const Curve> curve_of(const timbre::MotionVariable& variable,
                                                    const MotionChannels& motion);

/// What the parameters of a tree are bound to; zero for what depends on an event. @throws as curve_of()
[[nodiscard]] Bindings bindings_of(const std::vector<NamedVariable>& parameters, const MotionChannels& motion);

}  // namespace idiophone::timbre
