#include "line_model.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace idiophone::partials {
namespace {

// Work of all fits after which a search ends, some seconds. Sums of damped sines need less than a hundredth of it. The
// flat spectrum of a click would need a hundred times as much: broad lines in any number, fitted all together.
constexpr double most_work = 3e8;

/// Of one iteration of a fit, up to a factor.
double work_of(BinRange band, std::size_t lines) {
  return static_cast<double>(band.size()) * static_cast<double>(lines * lines);
}

}  // namespace

LineModel::LineModel(const LineSpectrum& line_spectrum, std::span<const double> samples, const SearchOptions& options)
    : line_spectrum_(line_spectrum), options_(options), remainder_(line_spectrum, samples, options) {}

bool LineModel::is_reported(const Line& line) const {
  const double bin = line_spectrum_.bin_of(line);
  return bin >= static_cast<double>(options_.reported.begin) && bin <= static_cast<double>(options_.reported.end - 1);
}

std::vector<std::size_t> LineModel::neighbours(const Line& line) const {
  const BinRange band = line_spectrum_.band_around(line);
  std::vector<std::size_t> result;
  for (std::size_t j = 0; j < lines_.size(); ++j) {
    const double bin = line_spectrum_.bin_of(lines_[j]);
    if (bin >= static_cast<double>(band.begin) && bin < static_cast<double>(band.end)) {
      result.push_back(j);
    }
  }
  return result;
}

std::vector<Line> LineModel::pick(const std::vector<std::size_t>& members) const {
  std::vector<Line> result(members.size());
  std::ranges::transform(members, result.begin(), [&](std::size_t j) { return lines_[j]; });
  return result;
}

BinRange LineModel::band_around_all(const std::vector<Line>& group) const {
  BinRange all = line_spectrum_.band_around(group.front());
  for (const Line& line : group) {
    const BinRange band = line_spectrum_.band_around(line);
    all = {.begin = std::min(all.begin, band.begin), .end = std::max(all.end, band.end)};
  }
  return all;
}

std::optional<std::size_t> LineModel::misfit(const std::vector<Line>& group, BinRange band) const {
  const double highest = remainder_.highest(band);
  for (std::size_t j = 0; j < group.size(); ++j) {
    const double bin = line_spectrum_.bin_of(group[j]);
    const bool inside = bin >= static_cast<double>(band.begin) && bin <= static_cast<double>(band.end - 1);
    const bool is_too_near = std::ranges::any_of(std::span(group).first(j), [&](const Line& other) {
      return is_reported(group[j]) && is_reported(other) &&
             std::abs(group[j].frequency - other.frequency) < options_.separation;
    });
    if (!inside || !(line_spectrum_.height(group[j]) < 20.0 * highest) || is_too_near) {
      return j;
    }
  }
  return {};
}

std::vector<Line> LineModel::fit(const std::vector<Line>& added_back, BinRange band, const std::vector<Line>& start) {
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

bool LineModel::add(const Line& candidate) {
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
    if (!complete_ || misfit(group, band)) {
      return false;
    }
    line = group.back();
  }
  const auto bin = static_cast<std::size_t>(std::lround(line_spectrum_.bin_of(line)));
  if (std::pow(line_spectrum_.height(line), 2) < remainder_.limits()[bin]) {
    group.pop_back();  // the better fit of the others needs no new line
  } else {
    lines_.push_back({.frequency = line.frequency, .damping = 0.0, .amplitude = 0.0});
    members.push_back(lines_.size() - 1);
  }
  replace(members, group);
  // They were fitted without the new line.
  for (const std::size_t member : members) {
    if (!refit(member)) {
      break;
    }
  }
  return true;
}

/// If the last line of a group lies within the width of another, both begin on either side of the peak. A peak at zero
/// frequency has one side only.
void LineModel::split_nearest(std::vector<Line>& group) const {
  const double bin = line_spectrum_.bin();
  Line& added = group.back();
  for (Line& other : std::span(group).first(group.size() - 1)) {
    const bool has_sides = std::min(added.frequency, other.frequency) > bin;
    if (has_sides && std::abs(line_spectrum_.bin_of(added) - line_spectrum_.bin_of(other)) < window_width) {
      added = {.frequency = other.frequency + bin, .damping = other.damping, .amplitude = 0.5 * other.amplitude};
      other = {.frequency = other.frequency - bin, .damping = other.damping, .amplitude = added.amplitude};
      return;
    }
  }
}

void LineModel::replace(const std::vector<std::size_t>& members, const std::vector<Line>& lines) {
  for (std::size_t j = 0; j < members.size(); ++j) {
    Line& line = lines_[members[j]];
    remainder_.add_back(line);
    line = lines[j];
    remainder_.subtract(line);
  }
}

bool LineModel::refit(std::size_t line) {
  std::vector<std::size_t> members = neighbours(lines_[line]);
  const std::vector<Line> before = pick(members);
  const BinRange band = band_around_all(before);
  std::vector<Line> after = fit(before, band, before);
  std::vector<std::size_t> wrong;
  while (const auto next = misfit(after, band)) {
    if (!complete_ || after.size() == 1) {
      return true;
    }
    const auto place = static_cast<std::ptrdiff_t>(*next);
    wrong.push_back(members[*next]);
    members.erase(members.begin() + place);
    after.erase(after.begin() + place);
    after = fit(before, band, after);
    if (!complete_) {
      return true;
    }
  }
  replace(members, after);
  give_up(std::move(wrong));
  return members.size() == before.size();
}

void LineModel::give_up(std::vector<std::size_t> members) {
  std::ranges::sort(members, std::greater());  // so that the numbers of the others stay
  for (const std::size_t member : members) {
    remainder_.add_back(lines_[member]);
    lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(member));
  }
}

Deviation LineModel::deviation(std::size_t line) const {
  auto members = neighbours(lines_[line]);
  std::erase(members, line);
  members.insert(members.begin(), line);
  const std::vector<Line> group = pick(members);
  const BinRange band = band_around_all(group);
  return deviations(line_spectrum_, remainder_.target(group, band), band, group).front();
}

}  // namespace idiophone::partials
