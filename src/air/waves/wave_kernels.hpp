#pragma once
// The kernels of the waves, compiled for an accelerator.

#include "idiophone/foundation/accelerator/kernel.hpp"

namespace idiophone::waves {

/// Functions of src/air/waves/kernels, by name.
struct WaveKernels {
  explicit WaveKernels(accelerator::Accelerator& accelerator);

  accelerator::Program program;
  accelerator::Kernel stretch_faces, step_cells;
  accelerator::Kernel add_node_rates, slow_ways, slow_nodes, cool_nodes, advance_nodes, publish_nodes;
  accelerator::Kernel gather, scatter;
};

}  // namespace idiophone::waves
