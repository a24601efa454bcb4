#include "idiophone/instruments/voices/body_ears.hpp"

#include <utility>

namespace idiophone::voices {

namespace {

constexpr std::int64_t turn_length = 1024;  // audio samples, from one direction to the next

}  // namespace

BodyEars::BodyEars(double longest_delay, std::vector<double> responses)
    : arrivals_(longest_delay), responses_(std::move(responses)), filter_(responses_) {}

void BodyEars::turn_to(std::vector<double> responses) {
  if (responses != responses_) {
    responses_ = std::move(responses);
    filter_.begin(responses_);
    left_ = turn_length;
  }
}

void BodyEars::hear(std::int64_t first, std::span<double> sound) {
  arrived_.assign(sound.size() / 2, 0.0);
  arrivals_.take(first, arrived_);
  for (std::size_t i = 0; i < arrived_.size(); ++i) {
    const double share = left_ > 0 ? 1.0 - static_cast<double>(left_) / turn_length : 0.0;
    const auto [left, right] = filter_.hear(arrived_[i], share);
    sound[2 * i] += left;
    sound[2 * i + 1] += right;
    if (left_ > 0 && --left_ == 0) {
      filter_.end();
    }
  }
}

}  // namespace idiophone::voices
