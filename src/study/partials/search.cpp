#include "search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "line_model.hpp"

namespace idiophone::partials {
namespace {

/// Whether it does not decay within one period.
bool swings(const Line& line) {
  return 2.0 * line.damping < line.frequency;
}

class Search {
 public:
  Search(const LineSpectrum& line_spectrum, std::span<const double> samples, const SearchOptions& options)
      : line_spectrum_(line_spectrum), options_(options), model_(line_spectrum, samples, options) {}

  /// Finds, fits and subtracts lines until no more are found.
  void run();

  [[nodiscard]] FoundLines found() const;

 private:
  /// @return whether a line was added
  bool subtract();
  /// @return whether a line was added
  bool add(const Line& candidate);
  void polish();
  /// See FoundLine. @param limits  of the remainder, [bins]
  [[nodiscard]] double remainder_of(const Line& line, const std::vector<double>& limits) const;

  const LineSpectrum& line_spectrum_;
  const SearchOptions& options_;
  LineModel model_;
};

void Search::run() {
  constexpr int most_rounds = 4;
  bool more = true;
  for (int round = 0; round < most_rounds && more && model_.complete(); ++round) {
    model_.remainder().forget_peaks();
    more = subtract();
    polish();
  }
}

bool Search::subtract() {
  // A sound that is not a sum of damped sines has any number of peaks that no line fits.
  const std::size_t most_attempts = 4 * options_.most;
  const auto reported = [&](const Line& line) { return model_.is_reported(line); };
  bool is_any_added = false;
  for (std::size_t attempt = 0; attempt < most_attempts && model_.complete(); ++attempt) {
    const auto peak = model_.remainder().next_peak();
    if (!peak || static_cast<std::size_t>(std::ranges::count_if(model_.lines(), reported)) >= options_.most) {
      break;
    }
    is_any_added = add(model_.remainder().line_at(*peak)) || is_any_added;
  }
  return is_any_added;
}

/// If no line fits a peak near zero frequency, it is a decay without oscillation: a line and its mirror image would
/// grow without bound to cancel each other.
bool Search::add(const Line& candidate) {
  return model_.add(candidate) ||
         (!swings(candidate) &&
          model_.add({.frequency = 0.0, .damping = candidate.damping, .amplitude = candidate.amplitude.real()}));
}

/// Fits every line again together with its neighbours, until the changes are small or due to noise alone: each line was
/// found before the fainter ones.
void Search::polish() {
  constexpr double converged = 1e-3;  // bins
  double moved = std::numeric_limits<double>::max();
  double moved_before = std::numeric_limits<double>::infinity();
  while (moved > converged && moved < 0.5 * moved_before && model_.complete()) {
    moved_before = moved;
    moved = 0.0;
    for (std::size_t j = 0; j < model_.lines().size(); ++j) {
      const double before = line_spectrum_.bin_of(model_.lines()[j]);
      if (model_.refit(j)) {
        moved = std::max(moved, std::abs(line_spectrum_.bin_of(model_.lines()[j]) - before));
      } else {
        moved = std::max(moved, 1.0);  // another line has this number, and its neighbours may move
      }
    }
  }
}

double Search::remainder_of(const Line& line, const std::vector<double>& limits) const {
  const double bin = line_spectrum_.bin_of(line);
  const double reach = std::max(window_width, line_spectrum_.width_of(line));
  const auto last = static_cast<double>(line_spectrum_.length());
  const auto begin = static_cast<std::size_t>(std::max(0.0, std::ceil(bin - reach)));
  const auto end = static_cast<std::size_t>(std::min(last, bin + reach)) + 1;
  const Bins rest = model_.remainder().target({}, {.begin = begin, .end = end});
  double highest = 0.0;
  for (std::size_t k = 0; k < rest.size(); ++k) {
    const double power = std::norm(rest[k]);
    highest = std::max(highest, power > limits[begin + k] ? power : 0.0);
  }
  return highest / std::pow(line_spectrum_.height(line), 2);
}

FoundLines Search::found() const {
  const std::vector<double> noise = model_.remainder().noise();
  const std::vector<double> limits = model_.remainder().limits();
  FoundLines result{.lines = {}, .complete = model_.complete()};
  for (std::size_t j = 0; j < model_.lines().size(); ++j) {
    const Line& line = model_.lines()[j];
    const double power = std::pow(line_spectrum_.height(line), 2);
    const double prominence = power / noise[std::lround(line_spectrum_.bin_of(line))];
    const bool is_faint = power < model_.remainder().faintest() || prominence < options_.prominence;
    if (!swings(line) || !model_.is_reported(line) || is_faint) {
      continue;
    }
    const Deviation deviation = model_.deviation(j);
    const double determined = 0.25 * std::max(line_spectrum_.width_of(line), window_width) * line_spectrum_.bin();
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

}  // namespace idiophone::partials
