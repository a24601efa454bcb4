#pragma once
// Velocities of surfaces on an accelerator.

#include <vector>

#include "idiophone/air/waves/velocity_history.hpp"
#include "wave_kernels.hpp"

namespace idiophone::waves {

/// A copy of a history, and what its signals change in each step of an audio sample.
class AcceleratorVelocities {
 public:
  /// @param history  must outlive this object
  AcceleratorVelocities(WaveKernels& kernels, const VelocityHistory& history);

  [[nodiscard]] const VelocityHistory& history() const { return history_; }
  /// Takes the audio samples that are new.
  void update();
  /// The number of the oldest audio sample of which changes() were computed.
  [[nodiscard]] std::int64_t oldest() const { return oldest_; }
  /// [steps x signals] Pa
  [[nodiscard]] const accelerator::Array<float>& changes() const { return changes_; }

 private:
  WaveKernels& kernels_;
  const VelocityHistory& history_;
  std::vector<std::int64_t> numbers_;  // of the audio samples in the ring
  std::int64_t oldest_ = -1;
  accelerator::Array<float> weights_, ring_, changes_;
};

}  // namespace idiophone::waves
