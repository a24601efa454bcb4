#pragma once
// Which computed mode a measured line is.

#include <optional>
#include <span>
#include <vector>

namespace idiophone::fitting {

/// A frequency that can be measured as one line or as several, as many as it has modes.
struct Candidate {
  double frequency = 0.0;  ///< Hz
  int modes = 1;
};

struct Matching {
  std::vector<std::optional<std::size_t>> candidate;  ///< [lines] index of the line's candidate; none for a false line
  double cost = 0.0;
};

/// The cheapest assignment of lines to candidates that keeps their order, by dynamic programming: a match costs the
/// square of its distance over the tolerance, a false line 1, and a candidate among the lines without a line 1/4.
/// @param lines       Hz, ascending
/// @param candidates  ascending
/// @param tolerance   the largest distance of a match, cents
[[nodiscard]] Matching match(std::span<const double> lines, std::span<const Candidate> candidates, double tolerance);

/// The candidates with frequencies that are higher by so many cents.
[[nodiscard]] std::vector<Candidate> raised_by(double cents, std::span<const Candidate> candidates);

/// Cents by which all candidates may have to rise, the likeliest first: those of the cheapest assignments, at least 60
/// cents apart. Of equally cheap ones, a smaller shift is likelier.
/// @param lines       Hz, ascending
/// @param candidates  ascending
/// @param largest     shift, cents
/// @param most        shifts
[[nodiscard]] std::vector<double> likely_shifts(std::span<const double> lines, std::span<const Candidate> candidates,
                                                double largest, int most);

}  // namespace idiophone::fitting
