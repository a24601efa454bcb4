#include "ready_sound.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::engines {

namespace {

constexpr double fall_time = 1e-3;  // s, by a factor of e
constexpr double inaudible = 1e-9;  // of a sound

}  // namespace

ReadySound::ReadySound(std::int64_t first, std::size_t channels, std::size_t frames, int rate)
    : channels_(channels), falling_(std::exp(-1.0 / (fall_time * rate))), ring_(frames), next_(first) {}

void ReadySound::put(std::span<const double> sound) {
  for (; !sound.empty(); sound = sound.subspan(channels_)) {
    Frame frame{};
    std::copy_n(sound.begin(), channels_, frame.begin());
    ring_.put(frame);
  }
}

void ReadySound::take(std::int64_t sample, std::span<double> sound) {
  if (sample > next_) {  // it began while the block before was played
    delay_.fetch_add(sample - next_, std::memory_order_release);
    next_ = sample;
  }
  for (; !sound.empty(); sound = sound.subspan(channels_), ++sample) {
    if (sample == next_) {
      take_next(sound.first(channels_));
    }
  }
}

void ReadySound::take_next(std::span<double> frame) {
  Frame ready{};
  if (ring_.take(ready)) {
    gain_ += (1.0 - gain_) * (1.0 - falling_);  // exactly 1 as long as there was no pause
    if (1.0 - gain_ < inaudible) {
      gain_ = 1.0;
      rest_ = {};
    }
  } else {
    pause();
  }
  for (std::size_t c = 0; c < channels_; ++c) {
    rest_[c] *= falling_;
    last_[c] = gain_ * ready[c] + rest_[c];
    frame[c] += last_[c];
  }
  ++next_;
}

/// Silence has nothing to fall.
void ReadySound::pause() {
  delay_.fetch_add(1, std::memory_order_release);
  if (last_ == Frame{}) {
    return;
  }
  if (gain_ > 0.0) {
    gaps_.fetch_add(1, std::memory_order_release);
  }
  gain_ = 0.0;
  rest_ = last_;
}

}  // namespace idiophone::engines
