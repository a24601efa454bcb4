#pragma once
// Pressures of the air when surfaces have moved.

#include <vector>

#include "idiophone/air/waves/cut_cells.hpp"

namespace idiophone::waves {

/// A field as WaveField has it.
struct FieldState {
  const CutCells& cut_cells;
  std::vector<float>& pressure;   ///< [cells, then nodes]
  std::vector<float>& rate;       ///< [cells]
  std::vector<float>& node_rate;  ///< [nodes]
};

/// Gives each new node the mean of the old nodes that its air belonged to, and each cell that is open now the mean of
/// its old nodes. Air that appears where there was none gets the mean pressure of the neighbouring cells, and no rate.
/// Ghost nodes remain to be exchanged.
void transfer(const Subdomain& subdomain, const FieldState& field, const CutCells& now);

}  // namespace idiophone::waves
