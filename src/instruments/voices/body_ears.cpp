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

std::array<double, 2> BodyEars::hear(std::int64_t sample) {
  const double share = left_ > 0 ? 1.0 - static_cast<double>(left_) / turn_length : 0.0;
  const std::array<double, 2> ears = filter_.hear(arrivals_.take(sample), share);
  if (left_ > 0 && --left_ == 0) {
    filter_.end();
  }
  return ears;
}

}  // namespace idiophone::voices
