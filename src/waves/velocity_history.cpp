#include "idiophone/waves/velocity_history.hpp"

#include <algorithm>

#include "idiophone/listening/spreading.hpp"

namespace idiophone::waves {

namespace {

const listening::Spreading& kernel() {
  return listening::Spreading::least_squares();
}

/// Adds the weights for the value at a time, in audio samples after the beginning of the interval; at least -1.
/// @param weights  of the samples from first() - 1 to first() + width() - 1, counted from the beginning
void add_weights(double time, double sign, std::vector<double>& weights) {
  const listening::Spreading::ArrivalCell cell = listening::Spreading::cell_of(time + 1.0);
  for (std::size_t n = 0; n < kernel().width(); ++n) {
    weights[n + cell.before] += sign * kernel().sound(cell, n / lane_count)[n % lane_count];
  }
}

}  // namespace

VelocityHistory::VelocityHistory(std::size_t signals, int steps)
    : samples_(kernel().width() + 1, std::vector<float>(signals)) {
  for (int step = 0; step < steps; ++step) {
    std::vector<double> weights(samples_.size());
    add_weights((step + 0.5) / steps, 1.0, weights);
    add_weights((step - 0.5) / steps, -1.0, weights);
    weights_.emplace_back(weights.begin(), weights.end());
  }
}

std::int64_t VelocityHistory::latency() {
  return kernel().first() + static_cast<std::int64_t>(kernel().width()) - 2;
}

void VelocityHistory::fill(std::span<const float> values) {
  for (auto& sample : samples_) {
    sample.assign(values.begin(), values.end());
  }
}

void VelocityHistory::push(std::span<const float> values) {
  samples_.push_back(std::move(samples_.front()));
  samples_.pop_front();
  samples_.back().assign(values.begin(), values.end());
}

void VelocityHistory::changes(int step, std::span<float> changes) const {
  std::ranges::fill(changes, 0.0F);
  for (std::size_t n = 0; n < samples_.size(); ++n) {
    const float weight = weights_[step][n];
    const float* const sample = samples_[n].data();
    for (std::size_t i = 0; i < changes.size(); ++i) {
      changes[i] += weight * sample[i];
    }
  }
}

std::vector<double> VelocityHistory::samples() const {
  std::vector<double> all;
  for (const auto& sample : samples_) {
    all.insert(all.end(), sample.begin(), sample.end());
  }
  return all;
}

void VelocityHistory::restore(std::span<const double> samples) {
  const std::size_t signals = samples.size() / samples_.size();
  for (std::size_t n = 0; n < samples_.size(); ++n) {
    const auto sample = samples.subspan(n * signals, signals);
    samples_[n].assign(sample.begin(), sample.end());
  }
}

}  // namespace idiophone::waves
