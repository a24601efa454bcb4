#include "accelerator_velocities.hpp"

namespace idiophone::waves {

namespace {

std::vector<float> weights_of(const VelocityHistory& history) {
  std::vector<float> all;
  for (int step = 0; step < history.steps(); ++step) {
    const auto weights = history.weights(step);
    all.insert(all.end(), weights.begin(), weights.end());
  }
  return all;
}

}  // namespace

AcceleratorVelocities::AcceleratorVelocities(WaveKernels& kernels, const VelocityHistory& history)
    : kernels_(kernels),
      history_(history),
      numbers_(VelocityHistory::length(), -1),
      weights_(kernels.program.accelerator(), weights_of(history)),
      ring_(kernels.program.accelerator(), VelocityHistory::length() * history.signals()),
      changes_(kernels.program.accelerator(), history.steps() * history.signals()) {}

void AcceleratorVelocities::update() {
  if (oldest_ == history_.oldest()) {
    return;
  }
  oldest_ = history_.oldest();
  constexpr int length = VelocityHistory::length();
  for (int n = 0; n < length; ++n) {
    const std::int64_t number = oldest_ + n;
    const auto place = static_cast<std::size_t>(number % length);
    if (numbers_[place] != number) {
      ring_.write(history_.sample(n), place * history_.signals());
      numbers_[place] = number;
    }
  }
  const int signals = static_cast<int>(history_.signals());
  kernels_.change_velocities({history_.signals(), 1, 1}, signals, history_.steps(), length,
                             static_cast<int>(oldest_ % length), weights_, ring_, changes_);
}

}  // namespace idiophone::waves
