#include "search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "noise.hpp"
#include "transform.hpp"

namespace idiophone::analysis {
namespace {

// No real line is shaped exactly like a damped sine; what a fit leaves below this share of it is not a line of its own.
constexpr double model_trust = 0.01;

// Full width at half power of a line that does not decay, bins.
constexpr double window_width = 2.5;

// Bins to either side of a line that a fit looks at, at least: six widths of the narrowest line.
constexpr double narrowest_reach = 12.0;

class Search {
 public:
  Search(const LineSpectrum& line_spectrum, std::span<const double> samples, const SearchOptions& options);

  /// Takes out lines and settles them until there are no more.
  void run();

  [[nodiscard]] std::vector<FoundLine> found() const;

 private:
  [[nodiscard]] double bin_of(const Line& line) const { return line.frequency * length_ / std::numbers::pi; }
  /// Full width at half power, bins.
  [[nodiscard]] double width_of(const Line& line) const {
    return 2.0 * std::abs(line.damping) * length_ / std::numbers::pi;
  }
  [[nodiscard]] bool is_reported(const Line& line) const;
  [[nodiscard]] Band band_around(const Line& line) const;
  [[nodiscard]] std::vector<double> limits() const;
  [[nodiscard]] std::optional<std::size_t> strongest_peak() const;
  [[nodiscard]] bool is_peak(std::size_t bin) const;
  [[nodiscard]] Line line_at(std::size_t peak) const;
  [[nodiscard]] std::vector<std::size_t> neighbours(const Line& line) const;
  [[nodiscard]] std::vector<Line> pick(const std::vector<std::size_t>& members) const;
  [[nodiscard]] Band band_around_all(const std::vector<Line>& group) const;
  [[nodiscard]] Bins target(const std::vector<Line>& taken_out, Band band) const;
  [[nodiscard]] bool acceptable(const std::vector<Line>& group, Band band) const;
  void add(const Line& candidate);
  void take_out();
  void polish();
  void split_nearest(std::vector<Line>& group) const;
  void refit(std::size_t j);
  void replace(const std::vector<std::size_t>& members, const std::vector<Line>& lines);
  void add_to_residual(const Line& line, double factor);

  const LineSpectrum& line_spectrum_;
  const SearchOptions& options_;
  double length_;
  Bins spectrum_;
  Bins residual_;  // spectrum less all lines
  std::vector<Line> lines_;
  std::vector<char> tried_;  // peaks already taken up; what comes back there is no line
  double faintest_ = 0.0;    // power
};

Search::Search(const LineSpectrum& line_spectrum, std::span<const double> samples, const SearchOptions& options)
    : line_spectrum_(line_spectrum),
      options_(options),
      length_(static_cast<double>(samples.size())),
      tried_(samples.size() + 1) {
  std::vector<double> windowed(samples.begin(), samples.end());
  for (std::size_t n = 0; n < windowed.size(); ++n) {
    windowed[n] *= line_spectrum.window(n);
  }
  Transform transform(2 * samples.size());
  const auto bins = transform(windowed);
  spectrum_.assign(bins.begin(), bins.end());
  residual_ = spectrum_;
  for (std::size_t k = options.reported.begin; k < options.reported.end; ++k) {
    faintest_ = std::max(faintest_, std::norm(spectrum_[k]) / options.dynamic_range);
  }
}

bool Search::is_reported(const Line& line) const {
  const double bin = bin_of(line);
  return bin >= static_cast<double>(options_.reported.begin) && bin <= static_cast<double>(options_.reported.end - 1);
}

Band Search::band_around(const Line& line) const {
  const double reach = std::max(narrowest_reach, 2.0 * width_of(line));
  const double last = length_;
  return {.begin = static_cast<std::size_t>(std::clamp(bin_of(line) - reach, 0.0, last - narrowest_reach)),
          .end = static_cast<std::size_t>(std::clamp(bin_of(line) + reach, narrowest_reach, last)) + 1};
}

/// Power above which a bin of the residual holds a line.
std::vector<double> Search::limits() const {
  std::vector<double> result = noise_power(residual_, options_.noise_reach);
  for (std::size_t k = 0; k < result.size(); ++k) {
    const double model = std::norm(spectrum_[k] - residual_[k]);
    result[k] = std::max({options_.prominence * result[k], faintest_, model_trust * model_trust * model});
  }
  return result;
}

std::optional<std::size_t> Search::strongest_peak() const {
  const std::vector<double> limit = limits();
  std::optional<std::size_t> strongest;
  for (std::size_t k = 0; k < residual_.size(); ++k) {
    const double power = std::norm(residual_[k]);
    const bool stronger = !strongest || power > std::norm(residual_[*strongest]);
    if (stronger && power > limit[k] && tried_[k] == 0 && is_peak(k)) {
      strongest = k;
    }
  }
  return strongest;
}

/// Whether the residual falls to half this bin's amplitude to both sides before it rises above it. Ripples on the
/// flanks that lines not yet settled leave over are no peaks.
bool Search::is_peak(std::size_t bin) const {
  const double power = std::norm(residual_[bin]);
  const auto turns = [&](double other) { return other > power || other < 0.25 * power; };
  const auto falls = [&](auto begin, auto end) {
    const auto turn = std::find_if(begin, end, [&](Complex other) { return turns(std::norm(other)); });
    return turn == end || std::norm(*turn) < power;
  };
  const auto here = residual_.begin() + static_cast<std::ptrdiff_t>(bin);
  return falls(here + 1, residual_.end()) && falls(std::make_reverse_iterator(here), residual_.rend());
}

/// First guess of a line from a peak of the residual: damping from its width, amplitude from its height.
Line Search::line_at(std::size_t peak) const {
  const double half = 0.5 * std::norm(residual_[peak]);
  std::size_t low = peak;
  std::size_t high = peak;
  while (low > 0 && std::norm(residual_[low]) > half) {
    --low;
  }
  while (high + 1 < residual_.size() && std::norm(residual_[high]) > half) {
    ++high;
  }
  const double width = std::max(static_cast<double>(high - low) - window_width, 0.5);
  Line line{.frequency = static_cast<double>(peak) * std::numbers::pi / length_,
            .damping = 0.5 * width * std::numbers::pi / length_,
            .amplitude = 1.0};
  line.amplitude = residual_[peak] / line_spectrum_.height(line);
  return line;
}

std::vector<std::size_t> Search::neighbours(const Line& line) const {
  const Band band = band_around(line);
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
  std::vector<Line> result;
  for (const std::size_t j : members) {
    result.push_back(lines_[j]);
  }
  return result;
}

Band Search::band_around_all(const std::vector<Line>& group) const {
  Band all = band_around(group.front());
  for (const Line& line : group) {
    const Band band = band_around(line);
    all = {.begin = std::min(all.begin, band.begin), .end = std::max(all.end, band.end)};
  }
  return all;
}

/// What the lines taken out of the residual have to make up.
Bins Search::target(const std::vector<Line>& taken_out, Band band) const {
  Bins result(residual_.begin() + static_cast<std::ptrdiff_t>(band.begin),
              residual_.begin() + static_cast<std::ptrdiff_t>(band.end));
  for (const Line& line : taken_out) {
    std::ranges::transform(result, line_spectrum_.spectrum(line, band), result.begin(), std::plus<>());
  }
  return result;
}

/// Whether lines are apart, where they were looked for, and not huge ones that cancel each other.
bool Search::acceptable(const std::vector<Line>& group, Band band) const {
  double highest = 0.0;
  for (std::size_t k = band.begin; k < band.end; ++k) {
    highest = std::max(highest, std::abs(spectrum_[k]));
  }
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

/// Fits a new line together with its neighbours and takes it out, if that makes sense.
void Search::add(const Line& candidate) {
  Line line = candidate;
  std::vector<std::size_t> members;
  std::vector<Line> group;
  // The first fit tells how broad the line is, and with that the second which bins to look at.
  for (int pass = 0; pass < 2; ++pass) {
    members = neighbours(line);
    const std::vector<Line> before = pick(members);
    group = before;
    group.push_back(line);
    if (pass == 0) {
      split_nearest(group);
    }
    const Band band = band_around_all(group);
    group = fit_lines(line_spectrum_, target(before, band), band, group);
    if (!acceptable(group, band)) {
      return;
    }
    line = group.back();
  }
  const auto bin = std::min(static_cast<std::size_t>(std::lround(bin_of(line))), residual_.size() - 1);
  if (std::pow(line_spectrum_.height(line), 2) < limits()[bin]) {
    group.pop_back();  // the others, fitted better, leave nothing for a new line
  } else {
    lines_.push_back({.frequency = line.frequency, .damping = 0.0, .amplitude = 0.0});
    members.push_back(lines_.size() - 1);
  }
  replace(members, group);
  // They were fitted while the new line disturbed them.
  for (const std::size_t member : members) {
    refit(member);
  }
}

/// Where the last of a group lies in the line of another, these two begin to either side of it.
void Search::split_nearest(std::vector<Line>& group) const {
  Line& added = group.back();
  for (Line& other : std::span(group).first(group.size() - 1)) {
    if (std::abs(bin_of(added) - bin_of(other)) < window_width) {
      const double bin = std::numbers::pi / length_;
      added = {.frequency = other.frequency + bin, .damping = other.damping, .amplitude = 0.5 * other.amplitude};
      other = {.frequency = std::abs(other.frequency - bin), .damping = other.damping, .amplitude = added.amplitude};
      return;
    }
  }
}

void Search::replace(const std::vector<std::size_t>& members, const std::vector<Line>& lines) {
  for (std::size_t j = 0; j < members.size(); ++j) {
    Line& line = lines_[members[j]];
    add_to_residual(line, 1.0);
    line = lines[j];
    add_to_residual(line, -1.0);
  }
}

void Search::add_to_residual(const Line& line, double factor) {
  const Bins bins = line_spectrum_.spectrum(line, line_spectrum_.all());
  for (std::size_t k = 0; k < bins.size(); ++k) {
    residual_[k] += factor * bins[k];
  }
}

void Search::run() {
  constexpr int most_rounds = 4;
  bool more = true;
  for (int round = 0; round < most_rounds && more; ++round) {
    const std::size_t before = lines_.size();
    std::ranges::fill(tried_, 0);
    take_out();
    polish();
    more = lines_.size() > before;
  }
}

void Search::take_out() {
  const auto reported = [&](const Line& line) { return is_reported(line); };
  while (static_cast<std::size_t>(std::ranges::count_if(lines_, reported)) < options_.most) {
    const auto peak = strongest_peak();
    if (!peak) {
      return;
    }
    tried_[*peak] = 1;
    add(line_at(*peak));
  }
}

/// Fits every line again, among its neighbours, until none moves or noise alone keeps them moving: each was found while
/// fainter ones disturbed it.
void Search::polish() {
  constexpr double settled = 1e-3;  // bins
  double moved = std::numeric_limits<double>::max();
  double moved_before = std::numeric_limits<double>::infinity();
  while (moved > settled && moved < 0.5 * moved_before) {
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
  const Band band = band_around_all(before);
  const auto after = fit_lines(line_spectrum_, target(before, band), band, before);
  if (acceptable(after, band)) {
    replace(members, after);
  }
}

std::vector<FoundLine> Search::found() const {
  const std::vector<double> noise = noise_power(residual_, options_.noise_reach);
  std::vector<FoundLine> result;
  for (std::size_t j = 0; j < lines_.size(); ++j) {
    const Line& line = lines_[j];
    const double power = std::pow(line_spectrum_.height(line), 2);
    const double prominence = power / noise[static_cast<std::size_t>(std::lround(bin_of(line)))];
    const bool swings = 2.0 * line.damping < line.frequency;  // broader than its frequency: a thump
    if (!swings || !is_reported(line) || power < faintest_ || prominence < options_.prominence) {
      continue;
    }
    auto members = neighbours(line);
    std::erase(members, j);
    members.insert(members.begin(), j);
    const std::vector<Line> group = pick(members);
    const Band band = band_around_all(group);
    const auto deviation = deviations(line_spectrum_, target(group, band), band, group).front();
    const double determined = 0.25 * std::max(width_of(line), window_width) * std::numbers::pi / length_;
    if (deviation.frequency < determined) {
      result.push_back({.line = line, .deviation = deviation, .prominence = prominence});
    }
  }
  return result;
}

}  // namespace

std::vector<FoundLine> find_lines(const LineSpectrum& line_spectrum, std::span<const double> samples,
                                  const SearchOptions& options) {
  Search search(line_spectrum, samples, options);
  search.run();
  return search.found();
}

}  // namespace idiophone::analysis
