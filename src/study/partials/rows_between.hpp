#pragma once
// Rows of a series between two times.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "idiophone/run/results/series_reader.hpp"

namespace idiophone::partials {

/// Rows of a series.
struct Rows {
  std::int64_t first = 0;
  std::int64_t count = 0;
};

/// The rows from `start` to `end` (s) that a series has; none where the end comes first.
[[nodiscard]] inline Rows rows_between(const results::SeriesReader& reader, const spectra::Series& series, double start,
                                       double end) {
  const std::int64_t all = reader.rows(series);
  const auto row_at = [&](double time) {
    return std::llround(std::clamp(time * series.rate, 0.0, static_cast<double>(all)));  // the end may be infinite
  };
  const auto first = std::clamp<std::int64_t>(row_at(start), 0, all);
  const auto last = std::clamp<std::int64_t>(row_at(end) + 1, first, all);
  return {first, last - first};
}

}  // namespace idiophone::partials
