#pragma once
// Pressures of the air when surfaces have moved.

#include "field_state.hpp"

namespace idiophone::waves {

/// Gives each new node the mean of the old nodes that its air belonged to, and each cell that is open now the mean of
/// its old nodes. Air that appears where there was none gets the mean pressure of the neighbouring cells, and no rate.
/// The surfaces of the field are still those before; ghost nodes remain to be exchanged.
void transfer(FieldState& field, const CutCells& now);

}  // namespace idiophone::waves
