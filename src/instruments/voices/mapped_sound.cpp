#include "mapped_sound.hpp"

#include <algorithm>
#include <bit>

namespace idiophone::voices {

MappedSound::MappedSound(std::span<const resonators::Complex> turns, std::size_t channels, const Reception& reception,
                         double longest_delay)
    : bank_(turns),
      channels_(channels),
      receivers_(reception.head.empty() ? channels : 1),
      outputs_(std::bit_ceil(receivers_)),
      gains_(2 * outputs_ * bank_.groups()),
      emitted_(resonators::ResonatorBank::most_samples * 2 * outputs_),
      delay_(reception.delay),
      arrivals_(receivers_, Arrivals(longest_delay)) {
  std::ranges::copy(reception.gains, gains_.begin());
  if (!reception.head.empty()) {
    head_.emplace(reception.head);
  }
}

void MappedSound::begin(const ReceptionChange& change, std::int64_t sample) {
  if (changing_) {
    end_change();
  }
  std::ranges::copy(change.reception.gains, gains_.begin() + static_cast<std::ptrdiff_t>(outputs_ * bank_.groups()));
  next_delay_ = change.reception.delay;
  if (head_) {
    head_->begin(change.reception.head);
  }
  change_start_ = sample;
  change_end_ = sample + change.length;
  changing_ = true;
}

void MappedSound::end_change() {
  std::copy_n(gains_.begin() + static_cast<std::ptrdiff_t>(outputs_ * bank_.groups()), outputs_ * bank_.groups(),
              gains_.begin());
  delay_ = next_delay_;
  if (head_) {
    head_->end();
  }
  changing_ = false;
}

double MappedSound::share(std::int64_t sample) const {
  return changing_ ? static_cast<double>(sample - change_start_) / static_cast<double>(change_end_ - change_start_)
                   : 0.0;
}

void MappedSound::render(std::int64_t first, std::span<const resonators::Drive> drives, std::span<double> sound) {
  const std::size_t samples = sound.size() / channels_;
  if (changing_ && first >= change_end_) {
    end_change();
  }
  if (!drives.empty() || bank_.sounds()) {
    emit(first, samples, drives);
  }
  for (std::size_t i = 0; i < samples; ++i) {
    const std::int64_t sample = first + static_cast<std::int64_t>(i);
    if (head_) {
      const auto [left, right] = head_->hear(arrivals_[0].take(sample), share(sample));
      sound[2 * i] += left;
      sound[2 * i + 1] += right;
      continue;
    }
    for (std::size_t r = 0; r < receivers_; ++r) {
      sound[i * receivers_ + r] += arrivals_[r].take(sample);
    }
  }
}

void MappedSound::emit(std::int64_t first, std::size_t samples, std::span<const resonators::Drive> drives) {
  const std::size_t outputs = changing_ ? 2 * outputs_ : outputs_;
  bank_.advance(drives, gains_, outputs, std::span(emitted_).first(samples * outputs));
  for (std::size_t i = 0; i < samples; ++i) {
    const std::int64_t sample = first + static_cast<std::int64_t>(i);
    const double* emitted = &emitted_[i * outputs];
    const double next = share(sample);
    for (std::size_t r = 0; r < receivers_; ++r) {
      if (changing_) {
        arrivals_[r].add(sample, (1.0 - next) * emitted[r] + next * emitted[outputs_ + r],
                         (1.0 - next) * delay_[r] + next * next_delay_[r]);
      } else {
        arrivals_[r].add(sample, emitted[r], delay_[r]);
      }
    }
  }
}

}  // namespace idiophone::voices
