#include "up_sampling.hpp"

#include <algorithm>

namespace idiophone::proxies {

double hermite(const std::array<double, 4>& samples, double share) {
  const double t = share, t2 = t * t, t3 = t2 * t;
  const double first_slope = samples[1] - samples[0], second_slope = samples[3] - samples[2];
  return (2.0 * t3 - 3.0 * t2 + 1.0) * samples[1] + (t3 - 2.0 * t2 + t) * first_slope +
         (-2.0 * t3 + 3.0 * t2) * samples[2] + (t3 - t2) * second_slope;
}

UpSampler::UpSampler(int largest_divisor)
    : largest_divisor_(largest_divisor), ring_(static_cast<std::size_t>(delay(largest_divisor)) + 1) {}

void UpSampler::restart(int divisor) {
  divisor_ = divisor;
  samples_ = {};
  std::ranges::fill(ring_, 0.0);
}

void UpSampler::add(double value) {
  std::ranges::copy(samples_.begin() + 1, samples_.end(), samples_.begin());
  samples_.back() = value;
}

double UpSampler::take(int place) {
  if (largest_divisor_ == 1) {
    return samples_.back();
  }
  const std::size_t wait = 2 * static_cast<std::size_t>(largest_divisor_ - divisor_);
  ring_[next_] = hermite(samples_, static_cast<double>(place) / divisor_);
  const double value = ring_[(next_ + ring_.size() - wait) % ring_.size()];
  next_ = (next_ + 1) % ring_.size();
  return value;
}

}  // namespace idiophone::proxies
