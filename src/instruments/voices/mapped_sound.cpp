#include "mapped_sound.hpp"

#include <algorithm>
#include <bit>
#include <numbers>
#include <utility>

#include "idiophone/instruments/voices/voice.hpp"
#include "masking_threshold.hpp"

namespace idiophone::voices {

MappedSound::MappedSound(resonators::ResonatorBank bank, std::size_t channels, const Reception& reception, int rate)
    : bank_(std::move(bank)),
      rate_(rate),
      bins_(bank_.groups() * resonators::modes_in_group),
      listener_(reception.listener),
      channels_(channels),
      receivers_(reception.head.empty() ? channels : 1),
      outputs_(std::bit_ceil(receivers_)),
      gains_(2 * outputs_ * bank_.groups()),
      outputs_of_modes_(resonators::ResonatorBank::most_samples * 2 * outputs_),
      emitted_(resonators::ResonatorBank::most_samples * receivers_),
      delay_(reception.delay) {
  std::ranges::copy(reception.gains, gains_.begin());
  find_bins();
  if (!reception.head.empty()) {
    arrivals_.emplace(longest_way * rate);
    head_.emplace(reception.head);
  }
}

void MappedSound::begin_piece() {
  done_ = 0;
  emits_ = false;
}

void MappedSound::retune(std::span<const resonators::ModeGroup> turns, double size) {
  bank_.retune(turns, size);
  find_bins();
}

void MappedSound::find_bins() {
  for (std::size_t mode = 0; mode < bins_.size(); ++mode) {
    const std::complex<double> turn = resonators::value_of(bank_.turns()[mode / resonators::modes_in_group], mode);
    bins_[mode] = MaskingThreshold::bin_of(std::abs(std::arg(turn)) / (2.0 * std::numbers::pi) * rate_);
  }
}

void MappedSound::measure(std::span<double> power) {
  bank_.catch_up();
  std::ranges::fill(power, 0.0);
  for (std::size_t group = 0; group < bank_.groups(); ++group) {
    const resonators::ModeGroup& z = bank_.states()[group];
    for (std::size_t p = 0; p < resonators::packs_in_group; ++p) {
      resonators::ModePack squares{};
      for (std::size_t r = 0; r < receivers_; ++r) {
        const resonators::ModeGroup& gain = gains_[r * bank_.groups() + group];
        squares += gain.real[p] * gain.real[p] + gain.imaginary[p] * gain.imaginary[p];
      }
      squares *= (z.real[p] * z.real[p] + z.imaginary[p] * z.imaginary[p]) / (2.0 * static_cast<double>(receivers_));
      for (std::size_t lane = 0; lane < resonators::modes_in_pack; ++lane) {
        power[group * resonators::modes_in_group + p * resonators::modes_in_pack + lane] = squares[lane];
      }
    }
  }
}

void MappedSound::begin(const ReceptionChange& change, std::int64_t sample) {
  if (is_changing(sample)) {
    stop_change(share(sample));
  } else if (changing_) {
    end_change();
  }
  std::ranges::copy(change.reception.gains, gains_.begin() + static_cast<std::ptrdiff_t>(outputs_ * bank_.groups()));
  next_delay_ = change.reception.delay;
  listener_ = change.reception.listener;
  leaves_ = change.leaves;
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

/// What is heard at this share of the change goes on.
void MappedSound::stop_change(double share) {
  const std::size_t count = outputs_ * bank_.groups();
  for (std::size_t i = 0; i < count; ++i) {
    resonators::ModeGroup& present = gains_[i];
    const resonators::ModeGroup& next = gains_[count + i];
    for (std::size_t p = 0; p < resonators::packs_in_group; ++p) {
      present.real[p] += share * (next.real[p] - present.real[p]);
      present.imaginary[p] += share * (next.imaginary[p] - present.imaginary[p]);
    }
  }
  for (std::size_t r = 0; r < receivers_; ++r) {
    delay_[r] += share * (next_delay_[r] - delay_[r]);
  }
}

double MappedSound::share(std::int64_t sample) const {
  return changing_ ? static_cast<double>(sample - change_start_) / static_cast<double>(change_end_ - change_start_)
                   : 0.0;
}

resonators::BodyInContact MappedSound::begin_contact(std::int64_t first, std::span<const resonators::Drive> drives,
                                                     std::size_t samples) {
  if (changing_ && first >= change_end_) {
    end_change();
  }
  return {.bank = &bank_,
          .drives = drives,
          .gains = gains_,
          .outputs = present_outputs(),
          .sound = std::span(outputs_of_modes_).first(samples * present_outputs())};
}

void MappedSound::end_contact(std::int64_t first, std::span<double> sound) {
  emit(first, sound.size() / channels_);
  finish(first, sound);
}

void MappedSound::render(std::int64_t first, std::span<const resonators::Drive> drives,
                         resonators::PointContacts& contacts, std::span<double> sound) {
  const std::size_t samples = sound.size() / channels_;
  const resonators::BodyInContact body = begin_contact(first, drives, samples);
  if (drives.empty() && !bank_.is_heard()) {
    bank_.rest(samples);
    if (emits_ || head_) {
      std::fill_n(emitted_.begin() + static_cast<std::ptrdiff_t>(done_ * receivers_), samples * receivers_, Emitted{});
    }
  } else {
    if (bank_.stretches(drives)) {
      resonators::advance_together({&body, 1}, contacts);
    } else {
      bank_.advance(drives, gains_, body.outputs, body.sound);
    }
    emit(first, samples);
  }
  finish(first, sound);
}

/// What leaves the body, from the outputs of its modes.
void MappedSound::emit(std::int64_t first, std::size_t samples) {
  if (!emits_) {
    std::fill_n(emitted_.begin(), done_ * receivers_, Emitted{});
  }
  emits_ = true;
  for (std::size_t i = 0; i < samples; ++i) {
    Emitted* emitted = &emitted_[(done_ + i) * receivers_];
    const double* present = &outputs_of_modes_[i * present_outputs()];
    const double next = share(first + static_cast<std::int64_t>(i));
    for (std::size_t r = 0; r < receivers_; ++r) {
      if (changing_) {
        emitted[r] = {.pressure = (1.0 - next) * present[r] + next * present[outputs_ + r],
                      .delay = (1.0 - next) * delay_[r] + next * next_delay_[r]};
      } else {
        emitted[r] = {.pressure = present[r], .delay = delay_[r]};
      }
    }
  }
}

void MappedSound::finish(std::int64_t first, std::span<double> sound) {
  const std::size_t samples = sound.size() / channels_;
  if (head_) {
    hear(first, std::span(emitted_).subspan(done_ * receivers_, samples * receivers_), sound);
  }
  done_ += samples;
}

void MappedSound::hear(std::int64_t first, std::span<const Emitted> emitted, std::span<double> sound) {
  std::array<double, resonators::ResonatorBank::most_samples> arrived{};
  for (std::size_t i = 0; i < emitted.size(); ++i) {
    if (emitted[i].pressure != 0.0) {
      arrivals_->add(first + static_cast<std::int64_t>(i), emitted[i].pressure, emitted[i].delay);
    }
  }
  arrivals_->take(first, std::span(arrived).first(emitted.size()));
  for (std::size_t i = 0; i < emitted.size(); ++i) {
    const auto [left, right] = head_->hear(arrived[i], share(first + static_cast<std::int64_t>(i)));
    sound[2 * i] += left;
    sound[2 * i + 1] += right;
  }
}

}  // namespace idiophone::voices
