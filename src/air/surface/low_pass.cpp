#include "idiophone/air/surface/low_pass.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace idiophone::surface {

namespace {

/// Eqs. 6-8 at a time in s, with half-width W in s, not normalised. The paper's text garbles eq. 8, a raised cosine.
double windowed_sinc(double time, double max_frequency, double half_width) {
  if (std::abs(time) >= half_width) {
    return 0.0;
  }
  const double angle = 2.0 * std::numbers::pi * max_frequency * time;
  const double sinc = angle == 0.0 ? 1.0 : std::sin(angle) / angle;
  return sinc * (0.5 + 0.5 * std::cos(std::numbers::pi * time / half_width));
}

/// A mean over h loses sin(pi f h)/(pi f h) = 1 - (pi f h)^2/6 + ...; taking h^2/24 of the kernel's second derivative,
/// by differences over h, off the kernel gives that back: to 0.003 dB at f_max for h = 1/(12 f_max).
double windowed_sinc_for_means(double time, double read, double max_frequency, double half_width) {
  const auto kernel = [&](double at) { return windowed_sinc(at, max_frequency, half_width); };
  const double bend = kernel(time - read) - 2.0 * kernel(time) + kernel(time + read);
  return std::abs(time) >= half_width ? 0.0 : kernel(time) - bend / 24.0;
}

/// Outputs that one input reaches, made a multiple of those added up at once.
std::size_t reached_outputs(const Sampling& sampling, std::size_t at_once) {
  return (2UL * sampling.latency() + at_once - 1) / at_once * at_once;
}

}  // namespace

LowPass::LowPass(const Sampling& sampling, ReadTime time, std::size_t width)
    : outputs_(reached_outputs(sampling, outputs_at_once)),
      taps_(2 * outputs_ * sampling.reads_per_sample()),
      sums_(width / pack_size * outputs_) {
  const double sample = 1.0 / sampling.rate;
  const double read = sample / sampling.reads_per_sample();
  const double half_width = sampling.half_width() * sample / sampling.steps_per_sample;
  const double centre = time == ReadTime::middle ? 0.5 : 0.0;
  double total = 0.0;
  for (std::size_t place = 0; place < taps_.size(); ++place) {
    const auto output = static_cast<double>(place % outputs_);
    const std::size_t reads_before = place / (2 * outputs_);
    // Time of the input as seen from the output, which is completed when this audio sample ends.
    const double from_output =
        (sampling.latency() - 1 - output) * sample + (static_cast<double>(reads_before) + 1.0 - centre) * read;
    taps_[place] = time == ReadTime::middle
                       ? windowed_sinc_for_means(from_output, read, sampling.max_frequency, half_width)
                       : windowed_sinc(from_output, sampling.max_frequency, half_width);
    total += taps_[place];
  }
  for (double& tap : taps_) {
    tap *= 2.0 / total;  // each row stands there twice
  }
}

void LowPass::fill(std::span<const double> values) {
  oldest_ = 0;
  std::vector<double> weights(outputs_);  // of all taps that an output has from earlier audio samples
  for (std::size_t output = outputs_ - 1; output > 0; --output) {
    weights[output - 1] = weights[output];
    for (std::size_t place = output; place < taps_.size(); place += 2 * outputs_) {
      weights[output - 1] += taps_[place];
    }
  }
  for (std::size_t signal = 0; signal < values.size(); ++signal) {
    for (std::size_t output = 0; output < outputs_; ++output) {
      sum(signal, output) = weights[output] * values[signal];
    }
  }
}

void LowPass::add(std::size_t pack, std::span<const double* const> reads, int first) {
  const std::size_t row = 2 * outputs_;
  const double* taps = &taps_[first * row + outputs_ - oldest_];
  for (std::size_t place = 0; place < outputs_; place += outputs_at_once) {
    AlignedBlock* sums = &sums_[pack * outputs_ + place];
    Lanes4 low[outputs_at_once], high[outputs_at_once];  // in registers
    for (std::size_t i = 0; i < outputs_at_once; ++i) {
      low[i] = load(sums[i].values.data());
      high[i] = load(&sums[i].values[lane_count]);
    }
    const double* tap = taps + place;
    for (const double* read : reads) {
      for (std::size_t i = 0; i < outputs_at_once; ++i) {
        low[i] += tap[i] * load(read);
        high[i] += tap[i] * load(read + lane_count);
      }
      tap += row;
    }
    for (std::size_t i = 0; i < outputs_at_once; ++i) {
      put(low[i], sums[i].values.data());
      put(high[i], &sums[i].values[lane_count]);
    }
  }
}

void LowPass::take(std::span<double> values) {
  for (std::size_t pack = 0; pack < values.size() / pack_size; ++pack) {
    const AlignedBlock sum = std::exchange(sums_[pack * outputs_ + oldest_], AlignedBlock{});
    std::ranges::copy(sum.values, &values[pack * pack_size]);
  }
  oldest_ = (oldest_ + 1) % outputs_;
}

double& LowPass::sum(std::size_t signal, std::size_t output) {
  return sums_[signal / pack_size * outputs_ + (oldest_ + output) % outputs_].values[signal % pack_size];
}

void LowPass::archive(std::size_t signal, parallel::ArchiveRow& row) {
  for (std::size_t output = 0; output < outputs_; ++output) {
    row.value(sum(signal, output));
  }
}

}  // namespace idiophone::surface
