#pragma once
// The kernels of the waves, compiled for an accelerator.

#include "idiophone/foundation/accelerator/kernel.hpp"

namespace idiophone::waves {

/// Functions of src/air/waves/kernels, by name.
struct WaveKernels {
  explicit WaveKernels(accelerator::Accelerator& accelerator);

  accelerator::Program program;
  accelerator::Kernel step_field;
  accelerator::Kernel node_rates_at_rest, slow_ways, slow_nodes, cool_nodes, advance_nodes, forecast_nodes;
  accelerator::Kernel change_velocities, add_sources;
  accelerator::Kernel gather, scatter;
};

}  // namespace idiophone::waves
