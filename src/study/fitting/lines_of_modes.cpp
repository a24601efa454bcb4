#include "idiophone/study/fitting/lines_of_modes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "idiophone/study/partials/compare.hpp"
#include "match.hpp"

namespace idiophone::fitting {

LinesOfModes lines_of_modes(std::span<const double> frequencies, const std::vector<Line>& lines, double tolerance) {
  constexpr double largest_shift = 1000.0;  // cents
  std::vector<double> measured;
  std::ranges::transform(lines, std::back_inserter(measured), &Line::frequency);
  std::vector<Candidate> candidates;
  std::ranges::transform(frequencies, std::back_inserter(candidates),
                         [](double frequency) { return Candidate{.frequency = frequency}; });
  LinesOfModes found;
  found.shift = likely_shifts(measured, candidates, largest_shift, 1).front();
  found.lines.resize(frequencies.size());
  const std::vector<Candidate> raised = raised_by(found.shift, candidates);
  const Matching matching = match(measured, raised, tolerance);
  for (std::size_t l = 0; l < lines.size(); ++l) {
    if (!matching.candidate[l]) {
      continue;
    }
    const double mode = raised[*matching.candidate[l]].frequency;
    const auto distance = [&](const Line& line) { return std::abs(partials::cents(line.frequency, mode)); };
    std::optional<Line>& line = found.lines[*matching.candidate[l]];
    if (!line || distance(lines[l]) < distance(*line)) {
      line = lines[l];
    }
  }
  return found;
}

}  // namespace idiophone::fitting
