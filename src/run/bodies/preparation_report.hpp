#pragma once
// What the user reads of a preparation.

#include "idiophone/run/bodies/preparation.hpp"

namespace idiophone::bodies {

/// Logs what bodies and contacts are like, and what limits the step. Call on rank 0.
void report(const Preparation& ready);

}  // namespace idiophone::bodies
