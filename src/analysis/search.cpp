#include "search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace idiophone::analysis {
namespace {

// Least number of fitted bins on either side of a line: six widths of the narrowest line.
constexpr double narrowest_reach = 12.0;

// Work of all fits after which a search ends, some seconds. Sums of damped sines need less than a hundredth of it. The
// flat spectrum of a click would need a hundred times as much: broad lines in any number, fitted all together.
constexpr double most_work = 3e8;

/// Of one iteration of a fit, up to a factor.
double work_of(BinRange band, std::size_t lines) {
  return static_cast<double>(band.size()) * static_cast<double>(lines * lines);
}

/// Otherwise it decays within one period.
bool swings(const Line& line) {
  return 2.0 * line.damping < line.frequency;
}

class Search {
 public:
  Search(const LineSpectrum& line_spectrum, std::span<const double> samples, const SearchOptions& options)
      : line_spectrum_(line_spectrum),
        options_(options),
        length_(static_cast<double>(samples.size())),
        remainder_(line_spectrum, samples, options) {}

  /// Finds, fits and subtracts lines until no more are found.
  void run();

  [[nodiscard]] FoundLines found() const;

 private:
  [[nodiscard]] double bin_of(const Line& line) const { return line.frequency * length_ / std::numbers::pi; }
  /// Full width at half power, bins.
  [[nodiscard]] double width_of(const Line& line) const {
    return 2.0 * std::abs(line.damping) * length_ / std::numbers::pi;
  }
  [[nodiscard]] bool is_reported(const Line& line) const;
  /// See FoundLine. @param limits  of the remainder, [bins]
  [[nodiscard]] double remainder_of(const Line& line, const std::vector<double>& limits) const;
  [[nodiscard]] BinRange band_around(const Line& line) const;
  [[nodiscard]] std::vector<std::size_t> neighbours(const Line& line) const;
  [[nodiscard]] std::vector<Line> pick(const std::vector<std::size_t>& members) const;
  [[nodiscard]] BinRange band_around_all(const std::vector<Line>& group) const;
  [[nodiscard]] bool acceptable(const std::vector<Line>& group, BinRange band) const;
  /// Lines fitted to the remainder with these lines added back; as they are when the search has to end.
  [[nodiscard]] std::vector<Line> fit(const std::vector<Line>& added_back, BinRange band,
                                      const std::vector<Line>& start);
  /// Fits a new line together with its neighbours and subtracts it.
  /// @return whether the fit was acceptable
  bool add(const Line& candidate);
  /// The same for a decay without oscillation instead of the line.
  void add_decay(const Line& candidate);
  void subtract();
  void polish();
  void split_nearest(std::vector<Line>& group) const;
  void refit(std::size_t j);
  void replace(const std::vector<std::size_t>& members, const std::vector<Line>& lines);

  const LineSpectrum& line_spectrum_;
  const SearchOptions& options_;
  double length_;
  Remainder remainder_;
  std::vector<Line> lines_;
  double work_ = 0.0;
  bool complete_ = true;
};

bool Search::is_reported(const Line& line) const {
  const double bin = bin_of(line);
  return bin >= static_cast<double>(options_.reported.begin) && bin <= static_cast<double>(options_.reported.end - 1);
}

BinRange Search::band_around(const Line& line) const {
  const double reach = std::max(narrowest_reach, 2.0 * width_of(line));
  const double last = length_;
  return {.begin = static_cast<std::size_t>(std::clamp(bin_of(line) - reach, 0.0, last - narrowest_reach)),
          .end = static_cast<std::size_t>(std::clamp(bin_of(line) + reach, narrowest_reach, last)) + 1};
}

std::vector<std::size_t> Search::neighbours(const Line& line) const {
  const BinRange band = band_around(line);
  std::vector<std::size_t> result;
  for (std::size_t j = 0; j < lines_.size(); ++j) {
    const double bin = bin_of(lines_[j]);
    if (bin >= static_cast<double>(band.begin) && bin < static_cast<double>(band.end)) {
      result.push_back(j);
    }
  }
  return result;
}

std::vector<Line> Search::pick(const std::vector<std::size_t>& members) const {
  std::vector<Line> result(members.size());
  std::ranges::transform(members, result.begin(), [&](std::size_t j) { return lines_[j]; });
  return result;
}

BinRange Search::band_around_all(const std::vector<Line>& group) const {
  BinRange all = band_around(group.front());
  for (const Line& line : group) {
    const BinRange band = band_around(line);
    all = {.begin = std::min(all.begin, band.begin), .end = std::max(all.end, band.end)};
  }
  return all;
}

/// Whether lines are separate, within the band, and not large ones that cancel each other.
bool Search::acceptable(const std::vector<Line>& group, BinRange band) const {
  const double highest = remainder_.highest(band);
  for (std::size_t j = 0; j < group.size(); ++j) {
    const double bin = bin_of(group[j]);
    const bool inside = bin >= static_cast<double>(band.begin) && bin <= static_cast<double>(band.end - 1);
    if (!inside || !(line_spectrum_.height(group[j]) < 20.0 * highest)) {
      return false;
    }
    for (std::size_t other = 0; other < j; ++other) {
      if (is_reported(group[j]) && is_reported(group[other]) &&
          std::abs(group[j].frequency - group[other].frequency) < options_.separation) {
        return false;
      }
    }
  }
  return true;
}

std::vector<Line> Search::fit(const std::vector<Line>& added_back, BinRange band, const std::vector<Line>& start) {
  constexpr double most_iterations = 60.0;
  const double work = work_of(band, start.size());
  const double affordable = std::floor((most_work - work_) / work);
  complete_ = complete_ && affordable >= 1.0;
  if (!complete_) {
    return start;
  }
  const auto iterations = static_cast<int>(std::min(most_iterations, affordable));
  Fit fit = fit_lines(line_spectrum_, remainder_.target(added_back, band), band, start, iterations);
  work_ += fit.iterations * work;
  return std::move(fit.lines);
}

bool Search::add(const Line& candidate) {
  Line line = candidate;
  std::vector<std::size_t> members;
  std::vector<Line> group;
  // The first fit gives the width of the line, which determines the band of the second fit.
  for (int pass = 0; pass < 2; ++pass) {
    members = neighbours(line);
    const std::vector<Line> before = pick(members);
    group = before;
    group.push_back(line);
    if (pass == 0) {
      split_nearest(group);
    }
    const BinRange band = band_around_all(group);
    group = fit(before, band, group);
    if (!complete_ || !acceptable(group, band)) {
      return false;
    }
    line = group.back();
  }
  const auto bin = static_cast<std::size_t>(std::lround(bin_of(line)));
  if (std::pow(line_spectrum_.height(line), 2) < remainder_.limits()[bin]) {
    group.pop_back();  // the better fit of the others needs no new line
  } else {
    lines_.push_back({.frequency = line.frequency, .damping = 0.0, .amplitude = 0.0});
    members.push_back(lines_.size() - 1);
  }
  replace(members, group);
  // They were fitted without the new line.
  for (const std::size_t member : members) {
    refit(member);
  }
  return true;
}

/// A line near zero frequency and its mirror image would grow without bound to cancel each other in two such decays.
void Search::add_decay(const Line& candidate) {
  add({.frequency = 0.0, .damping = candidate.damping, .amplitude = candidate.amplitude.real()});
}

/// If the last line of a group lies within the width of another, both begin on either side of the peak. A peak at zero
/// frequency has one side only.
void Search::split_nearest(std::vector<Line>& group) const {
  const double bin = std::numbers::pi / length_;
  Line& added = group.back();
  for (Line& other : std::span(group).first(group.size() - 1)) {
    const bool has_sides = std::min(added.frequency, other.frequency) > bin;
    if (has_sides && std::abs(bin_of(added) - bin_of(other)) < window_width) {
      added = {.frequency = other.frequency + bin, .damping = other.damping, .amplitude = 0.5 * other.amplitude};
      other = {.frequency = other.frequency - bin, .damping = other.damping, .amplitude = added.amplitude};
      return;
    }
  }
}

void Search::replace(const std::vector<std::size_t>& members, const std::vector<Line>& lines) {
  for (std::size_t j = 0; j < members.size(); ++j) {
    Line& line = lines_[members[j]];
    remainder_.add_back(line);
    line = lines[j];
    remainder_.subtract(line);
  }
}

void Search::run() {
  constexpr int most_rounds = 4;
  bool more = true;
  for (int round = 0; round < most_rounds && more && complete_; ++round) {
    const std::size_t before = lines_.size();
    remainder_.forget_peaks();
    subtract();
    polish();
    more = lines_.size() > before;
  }
}

void Search::subtract() {
  // A sound that is not a sum of damped sines has any number of peaks that no line fits.
  const std::size_t most_attempts = 4 * options_.most;
  const auto reported = [&](const Line& line) { return is_reported(line); };
  for (std::size_t attempt = 0; attempt < most_attempts && complete_; ++attempt) {
    const auto peak = remainder_.next_peak();
    if (!peak || static_cast<std::size_t>(std::ranges::count_if(lines_, reported)) >= options_.most) {
      return;
    }
    const Line line = remainder_.line_at(*peak);
    if (!add(line) && !swings(line)) {
      add_decay(line);
    }
  }
}

/// Fits every line again together with its neighbours, until the changes are small or due to noise alone: each line was
/// found before the fainter ones.
void Search::polish() {
  constexpr double converged = 1e-3;  // bins
  double moved = std::numeric_limits<double>::max();
  double moved_before = std::numeric_limits<double>::infinity();
  while (moved > converged && moved < 0.5 * moved_before && complete_) {
    moved_before = moved;
    moved = 0.0;
    for (std::size_t j = 0; j < lines_.size(); ++j) {
      const double before = bin_of(lines_[j]);
      refit(j);
      moved = std::max(moved, std::abs(bin_of(lines_[j]) - before));
    }
  }
}

void Search::refit(std::size_t j) {
  const auto members = neighbours(lines_[j]);
  const std::vector<Line> before = pick(members);
  const BinRange band = band_around_all(before);
  const std::vector<Line> after = fit(before, band, before);
  if (acceptable(after, band)) {
    replace(members, after);
  }
}

double Search::remainder_of(const Line& line, const std::vector<double>& limits) const {
  const double reach = std::max(window_width, width_of(line));
  const auto begin = static_cast<std::size_t>(std::max(0.0, std::ceil(bin_of(line) - reach)));
  const auto end = static_cast<std::size_t>(std::min(length_, bin_of(line) + reach)) + 1;
  const Bins rest = remainder_.target({}, {.begin = begin, .end = end});
  double highest = 0.0;
  for (std::size_t k = 0; k < rest.size(); ++k) {
    const double power = std::norm(rest[k]);
    highest = std::max(highest, power > limits[begin + k] ? power : 0.0);
  }
  return highest / std::pow(line_spectrum_.height(line), 2);
}

FoundLines Search::found() const {
  const std::vector<double> noise = remainder_.noise();
  const std::vector<double> limits = remainder_.limits();
  FoundLines result{.lines = {}, .complete = complete_};
  for (std::size_t j = 0; j < lines_.size(); ++j) {
    const Line& line = lines_[j];
    const double power = std::pow(line_spectrum_.height(line), 2);
    const double prominence = power / noise[std::lround(bin_of(line))];
    if (!swings(line) || !is_reported(line) || power < remainder_.faintest() || prominence < options_.prominence) {
      continue;
    }
    auto members = neighbours(line);
    std::erase(members, j);
    members.insert(members.begin(), j);
    const std::vector<Line> group = pick(members);
    const BinRange band = band_around_all(group);
    const auto deviation = deviations(line_spectrum_, remainder_.target(group, band), band, group).front();
    const double determined = 0.25 * std::max(width_of(line), window_width) * std::numbers::pi / length_;
    if (deviation.frequency < determined) {
      result.lines.push_back(
          {.line = line, .deviation = deviation, .prominence = prominence, .remainder = remainder_of(line, limits)});
    }
  }
  return result;
}

}  // namespace

FoundLines find_lines(const LineSpectrum& line_spectrum, std::span<const double> samples,
                      const SearchOptions& options) {
  Search search(line_spectrum, samples, options);
  search.run();
  return search.found();
}

}  // namespace idiophone::analysis
