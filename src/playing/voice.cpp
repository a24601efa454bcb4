#include "voice.hpp"

#include <algorithm>
#include <bit>

namespace idiophone::playing {

Voice::Voice(std::span<const Complex> turns, std::size_t receivers, Reception reception, double longest_delay)
    : bank_(turns),
      receivers_(receivers),
      outputs_(std::bit_ceil(receivers)),
      gains_(2 * outputs_ * bank_.groups()),
      emitted_(ResonatorBank::most_samples * 2 * outputs_),
      delay_(reception.delay),
      arrivals_(receivers, Arrivals(longest_delay)) {
  std::ranges::copy(reception.gains, gains_.begin());
}

void Voice::begin(const ReceptionChange& change, std::int64_t sample) {
  if (changing_) {
    end_change();
  }
  std::ranges::copy(change.reception.gains, gains_.begin() + static_cast<std::ptrdiff_t>(outputs_ * bank_.groups()));
  next_delay_ = change.reception.delay;
  change_start_ = sample;
  change_end_ = sample + change.length;
  changing_ = true;
}

void Voice::end_change() {
  std::copy_n(gains_.begin() + static_cast<std::ptrdiff_t>(outputs_ * bank_.groups()), outputs_ * bank_.groups(),
              gains_.begin());
  delay_ = next_delay_;
  changing_ = false;
}

void Voice::render(std::int64_t first, std::span<const Drive> drives, std::span<double> sound) {
  const std::size_t samples = sound.size() / receivers_;
  if (changing_ && first >= change_end_) {
    end_change();
  }
  if (!drives.empty() || bank_.sounds()) {
    emit(first, samples, drives);
  }
  for (std::size_t i = 0; i < samples; ++i) {
    for (std::size_t r = 0; r < receivers_; ++r) {
      sound[i * receivers_ + r] += arrivals_[r].take(first + static_cast<std::int64_t>(i));
    }
  }
}

void Voice::emit(std::int64_t first, std::size_t samples, std::span<const Drive> drives) {
  const std::size_t outputs = changing_ ? 2 * outputs_ : outputs_;
  bank_.advance(drives, gains_, outputs, std::span(emitted_).first(samples * outputs));
  for (std::size_t i = 0; i < samples; ++i) {
    const std::int64_t sample = first + static_cast<std::int64_t>(i);
    const double* emitted = &emitted_[i * outputs];
    const double share =
        changing_ ? static_cast<double>(sample - change_start_) / static_cast<double>(change_end_ - change_start_)
                  : 0.0;
    for (std::size_t r = 0; r < receivers_; ++r) {
      if (changing_) {
        arrivals_[r].add(sample, (1.0 - share) * emitted[r] + share * emitted[outputs_ + r],
                         (1.0 - share) * delay_[r] + share * next_delay_[r]);
      } else {
        arrivals_[r].add(sample, emitted[r], delay_[r]);
      }
    }
  }
}

}  // namespace idiophone::playing
