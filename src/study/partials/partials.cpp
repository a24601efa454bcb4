#include "idiophone/study/partials/partials.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "idiophone/foundation/spectra/spectrum.hpp"
#include "idiophone/foundation/spectra/transform.hpp"
#include "search.hpp"

namespace idiophone::partials {
namespace {

constexpr std::size_t fewest_samples = 64;
constexpr double noise_reach = 1000.0;  // Hz

void require(bool condition, const std::string& message) {
  if (!condition) {
    throw std::invalid_argument(message);
  }
}

double highest_frequency(const PartialOptions& options, double rate) {
  return options.highest.value_or(0.5 * rate);
}

void check(const PartialOptions& options, double rate) {
  const double highest = highest_frequency(options, rate);
  require(options.lowest >= 0.0 && options.lowest < highest && highest <= 0.5 * rate,
          fmt::format("partials can be found between 0 and {} Hz (half the rate), not from {} to {} Hz", 0.5 * rate,
                      options.lowest, highest));
  require(options.dynamic_range > 0.0 && options.dynamic_range <= 200.0,
          fmt::format("the dynamic range must be above 0 and at most 200 dB, it is {} dB", options.dynamic_range));
  require(options.prominence >= 6.0 && options.prominence <= 200.0,
          fmt::format("the prominence must be from 6 dB (below, noise itself is full of lines) to 200 dB, it is {} dB",
                      options.prominence));
  const double separation = options.separation.value_or(0.0);
  require(separation >= 0.0 && separation < highest,
          fmt::format("the separation must be from 0 to {} Hz, it is {} Hz", highest, separation));
}

/// The least distance of two partials, Hz. @param duration  of what is analysed, s
double separation(const PartialOptions& options, double duration) {
  return options.separation.value_or(std::min(0.5, 0.5 / duration));
}

/// The samples from options.start on, for options.duration.
std::span<const double> cut(std::span<const double> samples, double rate, const PartialOptions& options) {
  const double whole = static_cast<double>(samples.size()) / rate;
  const double duration = options.duration.value_or(whole - options.start);
  const double room = 0.5 / rate;
  require(options.start >= 0.0 && duration > 0.0 && options.start + duration <= whole + room,
          fmt::format("the sound lasts {} s; {} s from {} s on are not in it", whole, duration, options.start));
  const auto first = static_cast<std::size_t>(std::lround(options.start * rate));
  const auto count = std::min(static_cast<std::size_t>(std::lround(duration * rate)), samples.size() - first);
  require(count >= fewest_samples, fmt::format("partials need at least {} samples, there are {} from {} s on",
                                               fewest_samples, count, options.start));
  return samples.subspan(first, count);
}

double power_ratio(double decibels) {
  return std::pow(10.0, 0.1 * decibels);
}

SearchOptions search_options(const PartialOptions& options, double rate, std::size_t length) {
  const double bins_per_hertz = 2.0 * static_cast<double>(length) / rate;
  const auto first = static_cast<std::size_t>(std::ceil(options.lowest * bins_per_hertz));
  const auto last = static_cast<std::size_t>(std::floor(highest_frequency(options, rate) * bins_per_hertz));
  require(first <= last, fmt::format("the sound is too short to resolve frequencies from {} to {} Hz", options.lowest,
                                     highest_frequency(options, rate)));
  return {.reported = {.begin = first, .end = last + 1},
          .prominence = power_ratio(options.prominence),
          .dynamic_range = power_ratio(options.dynamic_range),
          .separation = 2.0 * std::numbers::pi * separation(options, static_cast<double>(length) / rate) / rate,
          .noise_reach = static_cast<std::size_t>(noise_reach * bins_per_hertz),
          .most = options.most};
}

Partial to_partial(const FoundLine& found, double rate) {
  const double hertz = rate / (2.0 * std::numbers::pi);
  Partial partial{.frequency = found.line.frequency * hertz,
                  .level = spectra::decibels(std::abs(found.line.amplitude)),
                  .decay_time = std::nullopt,
                  .frequency_deviation = found.deviation.frequency * hertz,
                  .prominence = 10.0 * std::log10(found.prominence),
                  .remainder = std::nullopt};
  if (found.remainder > 0.0) {
    partial.remainder = 10.0 * std::log10(found.remainder);
  }
  if (found.line.damping > 3.0 * found.deviation.damping) {
    partial.decay_time = std::log(1000.0) / (found.line.damping * rate);
  }
  return partial;
}

}  // namespace

Partials find_partials(std::span<const double> samples, double rate, const PartialOptions& options) {
  spectra::require_sound(samples, rate);
  check(options, rate);
  const auto sound = cut(samples, rate, options);
  const LineSpectrum line_spectrum(sound.size());
  const FoundLines lines = find_lines(line_spectrum, sound, search_options(options, rate, sound.size()));
  Partials partials{.found = {}, .complete = lines.complete};
  for (const FoundLine& line : lines.lines) {
    partials.found.push_back(to_partial(line, rate));
  }
  std::ranges::sort(partials.found, {}, &Partial::frequency);
  return partials;
}

}  // namespace idiophone::partials
