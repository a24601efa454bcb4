#pragma once
// A spectrum as a sum of lines and a remainder. Lines that overlap are fitted together.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fit.hpp"
#include "line.hpp"
#include "remainder.hpp"

namespace idiophone::partials {

/// The lines found so far, subtracted from the spectrum.
class LineModel {
 public:
  /// @param samples  [line_spectrum.length()]
  LineModel(const LineSpectrum& line_spectrum, std::span<const double> samples, const SearchOptions& options);

  /// Fits a new line together with its neighbours and subtracts it.
  /// @return whether the fit was acceptable
  bool add(const Line& candidate);

  /// Fits a line again together with its neighbours. Lines that are misfits in the new fit are given up: where two
  /// of them fall on one line, neither would be determined.
  /// @return false if lines were given up, so that others have new numbers
  bool refit(std::size_t line);

  /// In the order in which they were added.
  [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }

  [[nodiscard]] Remainder& remainder() { return remainder_; }
  [[nodiscard]] const Remainder& remainder() const { return remainder_; }

  /// Whether a line lies within the bins that are wanted.
  [[nodiscard]] bool is_reported(const Line& line) const;

  /// Of a line, when it is fitted together with its neighbours.
  [[nodiscard]] Deviation deviation(std::size_t line) const;

  /// False after the fits have taken so much work that the search has to end; see Partials.
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  [[nodiscard]] BinRange band_around_all(const std::vector<Line>& group) const;
  [[nodiscard]] std::vector<std::size_t> neighbours(const Line& line) const;
  [[nodiscard]] std::vector<Line> pick(const std::vector<std::size_t>& members) const;
  /// The first line that is outside the band, one of large ones that cancel each other, or not separate from another.
  [[nodiscard]] std::optional<std::size_t> misfit(const std::vector<Line>& group, BinRange band) const;
  /// Lines fitted to the remainder with these lines added back; as they are when the search has to end.
  [[nodiscard]] std::vector<Line> fit(const std::vector<Line>& added_back, BinRange band,
                                      const std::vector<Line>& start);
  void split_nearest(std::vector<Line>& group) const;
  void replace(const std::vector<std::size_t>& members, const std::vector<Line>& lines);
  void give_up(std::vector<std::size_t> members);

  const LineSpectrum& line_spectrum_;
  const SearchOptions& options_;
  Remainder remainder_;
  std::vector<Line> lines_;
  double work_ = 0.0;
  bool complete_ = true;
};

}  // namespace idiophone::partials
