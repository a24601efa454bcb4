#include "idiophone/study/partials/free_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace idiophone::partials {

namespace {

constexpr double jump = 10.0;            // of the power, at a blow or a click
constexpr std::size_t hops_before = 20;  // whose power a jump exceeds
constexpr double least_power = 1e-8;     // of a jump, of the loudest
constexpr double settling = 0.02;        // s, after the loudest sample of a blow
constexpr double attack = 0.01;          // s, in which a blow is loudest
constexpr double shortest = 0.05;        // s, of a part between two blows

/// Largest square of the second difference in each millisecond. @param hop  samples
std::vector<double> powers(std::span<const double> samples, std::size_t hop) {
  std::vector<double> all(samples.size() / hop + 1);
  for (std::size_t n = 2; n < samples.size(); ++n) {
    const double difference = samples[n] - 2 * samples[n - 1] + samples[n - 2];
    all[n / hop] = std::max(all[n / hop], difference * difference);
  }
  return all;
}

/// Samples at which blows and clicks begin, ascending, and the beginning of the sound.
std::vector<std::size_t> disturbances(std::span<const double> samples, double rate) {
  const auto hop = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(1e-3 * rate)));
  const std::vector<double> power = powers(samples, hop);
  const double loudest = *std::ranges::max_element(power);
  std::vector<std::size_t> found = {0};
  std::size_t next = 0;  // hop
  for (std::size_t h = 1; h < power.size(); ++h) {
    const auto here = power.begin() + static_cast<std::ptrdiff_t>(h);
    const double before = *std::max_element(here - static_cast<std::ptrdiff_t>(std::min(h, hops_before)), here);
    if (h >= next && power[h] > jump * before && power[h] > least_power * loudest) {
      found.push_back(h * hop);
      next = h + static_cast<std::size_t>(1e3 * attack);
    }
  }
  return found;
}

/// Where a sound without a jump has reached half of its largest amplitude.
std::size_t half_risen(std::span<const double> samples) {
  const auto magnitude = [](double sample) { return std::abs(sample); };
  const double half = magnitude(*std::ranges::max_element(samples, {}, magnitude)) / 2;
  return static_cast<std::size_t>(
      std::ranges::find_if(samples, [&](double sample) { return magnitude(sample) >= half; }) - samples.begin());
}

/// The loudest of the samples from `begin` on.
std::size_t loudest_sample(std::span<const double> samples, std::size_t begin, std::size_t end) {
  const auto part = samples.subspan(begin, std::min(end, samples.size()) - begin);
  const auto place = std::ranges::max_element(part, {}, [](double sample) { return std::abs(sample); });
  return begin + static_cast<std::size_t>(place - part.begin());
}

/// Energy of the first differences, which leave hum out, times the length, s.
double worth_of(const FreePart& part, std::span<const double> samples, double rate) {
  const auto first = static_cast<std::size_t>(part.start * rate);
  const auto last = std::min(samples.size(), static_cast<std::size_t>((part.start + part.duration) * rate));
  double energy = 0.0;
  for (std::size_t n = first + 1; n < last; ++n) {
    energy += std::pow(samples[n] - samples[n - 1], 2);
  }
  return energy * std::min(1.0, part.duration);
}

}  // namespace

std::vector<FreePart> free_parts(std::span<const double> samples, double rate) {
  std::vector<std::size_t> begins = disturbances(samples, rate);
  if (begins.size() == 1) {
    begins.front() = half_risen(samples);
  }
  std::vector<FreePart> parts;
  for (std::size_t b = 0; b < begins.size(); ++b) {
    const bool is_last = b + 1 == begins.size();
    const double end =
        is_last ? static_cast<double>(samples.size()) / rate : static_cast<double>(begins[b + 1]) / rate - 1e-3;
    const auto attack_end = begins[b] + 1 + static_cast<std::size_t>(attack * rate);
    const double blow = static_cast<double>(loudest_sample(samples, begins[b], attack_end)) / rate;
    const double start = blow + std::min(settling, std::max(0.0, end - blow) / 10);
    if (is_last || end - start >= shortest) {
      parts.push_back({start, end - start});
    }
  }
  std::ranges::stable_sort(parts, std::ranges::greater{},
                           [&](const FreePart& part) { return worth_of(part, samples, rate); });
  return parts;
}

}  // namespace idiophone::partials
