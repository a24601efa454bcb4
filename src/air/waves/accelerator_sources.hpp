#pragma once
// What surfaces add to the nodes, on an accelerator.

#include "accelerator_velocities.hpp"
#include "idiophone/air/waves/surface_sources.hpp"

namespace idiophone::waves {

/// As long as the surfaces stay where they are on the grid.
class AcceleratorSources {
 public:
  /// @param nodes  that the subdomain owns
  AcceleratorSources(WaveKernels& kernels, const SurfaceSources& sources, Index nodes, int steps);

  /// What velocities add to the nodes in all steps of their audio sample.
  /// @param velocities  up to date
  /// @return [steps x nodes] Pa per step
  const accelerator::Array<float>& of(const AcceleratorVelocities& velocities);

 private:
  WaveKernels& kernels_;
  Index nodes_;
  int steps_;
  std::int64_t oldest_ = -1;  // audio sample of the velocities
  accelerator::Array<Index> first_piece_;
  accelerator::Array<SurfaceSources::Piece> pieces_;
  accelerator::Array<float> sources_;
};

}  // namespace idiophone::waves
