#include "recurring_partials.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone::report {

namespace {

constexpr double audible_range = 60.0;  // dB

/// A partial, and where it was found.
struct Found {
  partials::Partial partial;
  std::size_t impact = 0;
  double duration = 0.0;  ///< of the analysis, s
};

struct Line {
  Found loudest;
  std::vector<std::size_t> impacts;
};

/// Half the width of a decaying line at half its power, Hz: the decay of its amplitude over 2 pi.
double half_width(const partials::Partial& partial) {
  return partial.decay_time ? std::log(1000.0) / (2.0 * std::numbers::pi * *partial.decay_time) : 0.0;
}

/// The distance within which two partials can't be told apart, Hz.
double resolution(const Found& one, const Found& other) {
  const double of_analysis = 1.0 / std::min(one.duration, other.duration);
  const double of_ears = one.partial.frequency * (std::exp2(5.0 / 1200.0) - 1.0);
  return std::max({of_analysis, half_width(one.partial), half_width(other.partial), of_ears});
}

double hertz_between(const Found& one, const Found& other) {
  return std::abs(one.partial.frequency - other.partial.frequency);
}

/// All partials, the loudest first. A search that ended early finds lines of clicks, so it counts only if all did.
std::vector<Found> all_found(std::span<const Stretch> stretches) {
  const auto is_complete = [](const Stretch& each) { return each.duration > 0.0 && each.partials.complete; };
  const bool can_choose = std::ranges::any_of(stretches, is_complete);
  std::vector<Found> all;
  for (std::size_t impact = 0; impact < stretches.size(); ++impact) {
    if (can_choose && !is_complete(stretches[impact])) {
      continue;
    }
    for (const partials::Partial& partial : stretches[impact].partials.found) {
      all.push_back({.partial = partial, .impact = impact, .duration = stretches[impact].duration});
    }
  }
  std::ranges::stable_sort(
      all, [](const Found& one, const Found& other) { return one.partial.level > other.partial.level; });
  if (!all.empty()) {
    const double least = all.front().partial.level - audible_range;
    std::erase_if(all, [&](const Found& found) { return found.partial.level < least; });
  }
  return all;
}

std::vector<Line> joined_lines(const std::vector<Found>& all) {
  std::vector<Line> lines;
  for (const Found& found : all) {
    Line* nearest = nullptr;
    for (Line& line : lines) {
      if (hertz_between(line.loudest, found) <= resolution(line.loudest, found) &&
          (nearest == nullptr || hertz_between(line.loudest, found) < hertz_between(nearest->loudest, found))) {
        nearest = &line;
      }
    }
    if (nearest == nullptr) {
      nearest = &lines.emplace_back(Line{.loudest = found, .impacts = {}});
    }
    if (std::ranges::find(nearest->impacts, found.impact) == nearest->impacts.end()) {
      nearest->impacts.push_back(found.impact);
    }
  }
  return lines;
}

}  // namespace

std::vector<RecurringPartial> recurring_partials(std::span<const Stretch> stretches) {
  std::vector<RecurringPartial> recurring;
  for (const Line& line : joined_lines(all_found(stretches))) {
    recurring.push_back({.loudest = line.loudest.partial, .impacts = line.impacts.size()});
  }
  std::ranges::sort(recurring, {}, [](const RecurringPartial& each) { return each.loudest.frequency; });
  return recurring;
}

}  // namespace idiophone::report
