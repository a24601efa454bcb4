#include "stretches.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace idiophone::report {

namespace {

constexpr double longest_analysis = 4.0;    // s; more takes long and hardly changes the partials
constexpr double shortest_analysis = 0.04;  // s, before another blow
constexpr double longest_rise = 0.1;        // s, from the blow to the largest sample
constexpr double longest_blow = 0.02;       // s after the largest sample
constexpr double margin = 0.01;             // s before another blow
constexpr double dynamic_range = 60.0;      // dB
constexpr std::size_t fewest_samples = 64;  // of an analysis

/// The samples between an impact and the next one, [begin, end).
using Interval = std::pair<std::size_t, std::size_t>;

std::vector<Interval> intervals(std::size_t samples, double rate, std::span<const Impact> impacts) {
  const auto sample_at = [&](double time) {
    return static_cast<std::size_t>(std::clamp(time * rate, 0.0, static_cast<double>(samples)));
  };
  std::vector<Interval> all;
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    const std::size_t begin = sample_at(impacts[i].time);
    const bool is_last = i + 1 == impacts.size();
    all.emplace_back(begin, is_last ? samples : std::max(begin, sample_at(impacts[i + 1].time - margin)));
  }
  return all;
}

/// Where the largest sample is, soon after the begin.
std::size_t peak_of(std::span<const double> samples, double rate, const Interval& interval) {
  const auto [begin, end] = interval;
  const auto part = samples.subspan(begin, std::min(end - begin, static_cast<std::size_t>(longest_rise * rate)));
  const auto found = std::ranges::max_element(part, {}, [](double sample) { return std::abs(sample); });
  return begin + static_cast<std::size_t>(found - part.begin());
}

double peak_sample(std::span<const double> samples, double rate, const Interval& interval) {
  return interval.first < interval.second ? std::abs(samples[peak_of(samples, rate, interval)]) : 0.0;
}

/// When the blow is over: soon after its largest sample, and after the last touch of bodies that part before the end.
double start_of(double peak, double last_contact, double end) {
  const double soon = peak + std::min(longest_blow, std::max(0.0, end - peak) / 10);
  const double separated = last_contact + longest_blow;
  return separated + shortest_analysis < end ? std::max(soon, separated) : soon;
}

Stretch stretch_of(std::span<const double> samples, double rate, const Interval& interval, double last_contact) {
  const double end = static_cast<double>(interval.second) / rate;
  const double peak = static_cast<double>(peak_of(samples, rate, interval)) / rate;
  Stretch stretch{.peak = peak_sample(samples, rate, interval), .start = start_of(peak, last_contact, end)};
  const double duration = std::min(end - stretch.start, longest_analysis);
  const bool is_last = interval.second == samples.size();
  if (duration * rate < fewest_samples || (!is_last && duration < shortest_analysis)) {
    return stretch;
  }
  stretch.duration = duration;
  stretch.partials = partials::find_partials(
      samples, rate, {.start = stretch.start, .duration = duration, .dynamic_range = dynamic_range});
  return stretch;
}

}  // namespace

std::vector<Stretch> stretches(std::span<const double> samples, double rate, std::span<const Impact> impacts) {
  std::vector<Stretch> all;
  for (const Interval& interval : intervals(samples.size(), rate, impacts)) {
    all.push_back(stretch_of(samples, rate, interval, impacts[all.size()].end));
  }
  return all;
}

std::vector<double> peaks(std::span<const double> samples, double rate, std::span<const Impact> impacts) {
  std::vector<double> all;
  for (const Interval& interval : intervals(samples.size(), rate, impacts)) {
    all.push_back(peak_sample(samples, rate, interval));
  }
  return all;
}

const Stretch& loudest(std::span<const Stretch> stretches) {
  return *std::ranges::max_element(stretches, {}, &Stretch::peak);
}

}  // namespace idiophone::report
