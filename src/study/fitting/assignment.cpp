#include "assignment.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "match.hpp"

namespace idiophone::fitting {

namespace {

std::vector<double> frequencies_of(const std::vector<Line>& lines) {
  std::vector<double> frequencies;
  std::ranges::transform(lines, std::back_inserter(frequencies), &Line::frequency);
  return frequencies;
}

/// Multiplets by ascending frequency, which is not the model's order with every material.
struct Spectrum {
  std::vector<std::size_t> multiplets;
  std::vector<Candidate> candidates;
};

Spectrum spectrum_of(const FrequencyModel& model, const TurnedMaterial& material) {
  const Eigen::VectorXd frequencies = model.frequencies(material);
  Spectrum spectrum;
  spectrum.multiplets.resize(model.multiplets().size());
  std::iota(spectrum.multiplets.begin(), spectrum.multiplets.end(), 0);
  std::ranges::sort(spectrum.multiplets, {}, [&](std::size_t m) { return frequencies[m]; });
  for (const std::size_t m : spectrum.multiplets) {
    spectrum.candidates.push_back({frequencies[m], model.multiplets()[m].count});
  }
  return spectrum;
}

}  // namespace

Assignment assign(const std::vector<Line>& lines, const FrequencyModel& model, const TurnedMaterial& material,
                  double tolerance) {
  const Spectrum spectrum = spectrum_of(model, material);
  const Matching matching = match(frequencies_of(lines), spectrum.candidates, tolerance);
  Assignment assigned{.pairs = {}, .cost = matching.cost};
  for (std::size_t l = 0; l < lines.size(); ++l) {
    if (matching.candidate[l]) {
      assigned.pairs.emplace_back(l, spectrum.multiplets[*matching.candidate[l]]);
    }
  }
  return assigned;
}

std::vector<double> common_shifts(const std::vector<Line>& lines, const FrequencyModel& model,
                                  const TurnedMaterial& material, double largest, int most) {
  return likely_shifts(frequencies_of(lines), spectrum_of(model, material).candidates, largest, most);
}

}  // namespace idiophone::fitting
