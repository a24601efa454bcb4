#include "match.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "idiophone/study/partials/compare.hpp"

namespace idiophone::fitting {

namespace {

constexpr double false_line = 1.0;
constexpr double missing_mode = 0.25;

/// The cheapest way to treat the first lines and the first candidates.
struct Cell {
  double cost = std::numeric_limits<double>::infinity();
  int taken = -1;  ///< lines that the last candidate takes; -1: the last line is false
};

}  // namespace

Matching match(std::span<const double> lines, std::span<const Candidate> candidates, double tolerance) {
  const std::size_t width = lines.size() + 1;
  std::vector<Cell> cells(width * (candidates.size() + 1));
  const auto at = [&](std::size_t done_lines, std::size_t done_candidates) -> Cell& {
    return cells[done_candidates * width + done_lines];
  };
  const auto improve = [](Cell& cell, double cost, int taken) {
    if (cost < cell.cost) {
      cell = {cost, taken};
    }
  };
  at(0, 0).cost = 0.0;
  for (std::size_t c = 0; c <= candidates.size(); ++c) {
    for (std::size_t l = 0; l < width; ++l) {
      const double cost = at(l, c).cost;
      if (l < lines.size()) {
        improve(at(l + 1, c), cost + false_line, -1);
      }
      if (c == candidates.size()) {
        continue;
      }
      const Candidate& next = candidates[c];
      const bool is_among = next.frequency > lines.front() && next.frequency < lines.back();
      improve(at(l, c + 1), cost + (is_among ? missing_mode : 0.0), 0);
      double matched = cost;
      for (int taken = 1; taken <= next.modes && l + taken <= lines.size(); ++taken) {
        const double distance = partials::cents(lines[l + taken - 1], next.frequency) / tolerance;
        if (std::abs(distance) > 1) {
          break;
        }
        matched += distance * distance;
        improve(at(l + taken, c + 1), matched, taken);
      }
    }
  }
  Matching found{std::vector<std::optional<std::size_t>>(lines.size()), at(lines.size(), candidates.size()).cost};
  for (std::size_t l = lines.size(), c = candidates.size(); l > 0 || c > 0;) {
    const int taken = at(l, c).taken;
    if (taken < 0) {
      --l;
      continue;
    }
    --c;
    for (int i = 0; i < taken; ++i) {
      found.candidate[--l] = c;
    }
  }
  return found;
}

std::vector<Candidate> raised_by(double cents, std::span<const Candidate> candidates) {
  std::vector<Candidate> raised(candidates.begin(), candidates.end());
  for (Candidate& candidate : raised) {
    candidate.frequency *= std::exp2(cents / 1200);
  }
  return raised;
}

std::vector<double> likely_shifts(std::span<const double> lines, std::span<const Candidate> candidates, double largest,
                                  int most) {
  constexpr double stride = 10.0;
  constexpr double tolerance = 100.0;
  constexpr double apart = 60.0;
  struct Shift {
    double cents;
    double cost;
  };
  std::vector<Shift> shifts;
  const auto strides = static_cast<int>(largest / stride);
  for (int number = -strides; number <= strides; ++number) {
    const double cents = stride * number;
    const double unlikely = 0.5 * std::pow(cents / 700, 2);
    shifts.push_back({cents, match(lines, raised_by(cents, candidates), tolerance).cost + unlikely});
  }
  std::ranges::sort(shifts, {}, &Shift::cost);
  std::vector<double> likeliest;
  for (const Shift& shift : shifts) {
    const auto is_near = [&](double other) { return std::abs(other - shift.cents) < apart; };
    if (static_cast<int>(likeliest.size()) < most && std::ranges::none_of(likeliest, is_near)) {
      likeliest.push_back(shift.cents);
    }
  }
  return likeliest;
}

}  // namespace idiophone::fitting
