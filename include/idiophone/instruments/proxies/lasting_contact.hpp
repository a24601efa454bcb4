#pragma once
// Contacts that last: resting, rolling and sliding, as a physics engine reports them step by step.

#include "idiophone/instruments/proxies/engine.hpp"

namespace idiophone::proxies {

/// The force of one physics step of a contact that lasts: a Hann window over this step and the next. Equal impulses of
/// successive steps add up to a constant force, so that a contact makes no clicks at the rate of the physics, and a
/// ball of facets none when it rolls from one facet to the next (O'Morain 2005, section 4.4.3).
/// @param start    audio sample at which the step began
/// @param impulse  of the step, N s
/// @param samples  audio samples in a step, at least 1
[[nodiscard]] Force lasting_contact(std::size_t body, std::int64_t start, const Vector3& at, const Vector3& impulse,
                                    int samples, int rate);

}  // namespace idiophone::proxies
