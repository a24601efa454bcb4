#include "idiophone/air/waves/velocity_history.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace idiophone::waves {

namespace {

/// Shape of Kaiser's window.
constexpr double window_shape = 8.0;

/// A sinc in Kaiser's window. Both are even.
double windowed_sinc(double x, double half_width) {
  const double angle = std::numbers::pi * x;
  const double sinc = x == 0.0 ? 1.0 : std::sin(angle) / angle;
  const double inside = 1.0 - std::pow(x / half_width, 2);
  return inside > 0.0 ? sinc * std::cyl_bessel_i(0.0, window_shape * std::sqrt(inside)) : 0.0;
}

/// Weights of so many audio samples before and after the beginning of the interval for the value at a time in it, in
/// audio samples. Constants are exact.
std::vector<double> weights_at(double time, int half_width) {
  std::vector<double> weights;
  for (int n = -half_width; n <= half_width; ++n) {
    weights.push_back(windowed_sinc(n - time, half_width));
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::ranges::transform(weights, weights.begin(), [sum](double weight) { return weight / sum; });
  return weights;
}

}  // namespace

VelocityHistory::VelocityHistory(std::size_t signals, int steps) : samples_(length(), std::vector<float>(signals)) {
  for (int step = 0; step < steps; ++step) {
    const std::vector<double> after = weights_at((step + 0.5) / steps, half_width);
    const std::vector<double> before = weights_at((step - 0.5) / steps, half_width);
    auto& weights = weights_.emplace_back();
    std::ranges::transform(after, before, std::back_inserter(weights),
                           [](double a, double b) { return static_cast<float>(a - b); });
  }
}

void VelocityHistory::fill(std::span<const float> values) {
  for (auto& sample : samples_) {
    sample.assign(values.begin(), values.end());
  }
  oldest_ += length();
}

void VelocityHistory::push(std::span<const float> values) {
  samples_.push_back(std::move(samples_.front()));
  samples_.pop_front();
  samples_.back().assign(values.begin(), values.end());
  ++oldest_;
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
  oldest_ += length();
}

}  // namespace idiophone::waves
