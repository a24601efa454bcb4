#include "idiophone/study/fitting/identification.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "assignment.hpp"
#include "doubts.hpp"
#include "fit_damping.hpp"
#include "fit_directional_loss.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "material_fit.hpp"

namespace idiophone::fitting {

namespace {

/// Gives lines without a mode the mode of a line that is as good as at the same place.
void add_split_lines(std::vector<AssignedLine>& lines) {
  constexpr double close = 10.0;  // cents
  const std::vector<AssignedLine> before = lines;
  for (AssignedLine& line : lines) {
    for (const AssignedLine& other : before) {
      if (line.modes == 0 && other.modes > 0 &&
          std::abs(partials::cents(line.line.frequency, other.line.frequency)) < close) {
        line.first_mode = other.first_mode;
        line.modes = other.modes;
        line.computed = other.computed;
        line.cents = partials::cents(line.line.frequency, line.computed);
        line.is_fitted = false;
        line.is_split = true;
      }
    }
  }
}

/// All lines with their modes, also those that were not fitted, and the modes without a line.
void add_lines(const std::vector<Line>& lines, const MaterialFit& fit, double tolerance, Identification& result) {
  const FrequencyModel& model = fit.model();
  const Eigen::VectorXd frequencies = model.frequencies(fit.material());
  std::vector<bool> seen(model.multiplets().size());
  for (std::size_t l = 0; l < lines.size(); ++l) {
    result.lines.push_back({.line = lines[l], .is_fitted = l < fit.fitted_lines()});
  }
  for (const auto& [l, m] : assign(lines, model, fit.material(), tolerance).pairs) {
    AssignedLine& line = result.lines[l];
    line.first_mode = model.multiplets()[m].first + 1;
    line.modes = model.multiplets()[m].count;
    line.computed = frequencies[m];
    line.cents = partials::cents(line.line.frequency, line.computed);
    line.mesh_error = line.is_fitted ? fit.mesh_error(l) : 0.0;
    seen[m] = true;
  }
  for (std::size_t m = 0; m < seen.size(); ++m) {
    if (!seen[m] && frequencies[m] > lines.front().frequency && frequencies[m] < lines.back().frequency) {
      const Multiplet& multiplet = model.multiplets()[m];
      result.missing.push_back({multiplet.first + 1, multiplet.count, frequencies[m]});
    }
  }
}

/// Decays of the lines that have a mode, with what it strains.
std::vector<StrainedDecay> strained_decays(const std::vector<AssignedLine>& lines,
                                           const std::vector<Multiplet>& multiplets) {
  std::vector<StrainedDecay> decays;
  for (const AssignedLine& line : lines) {
    if (line.modes > 0 && line.line.decay_time) {
      const auto multiplet = std::ranges::find(multiplets, line.first_mode - 1, &Multiplet::first);
      decays.push_back({{line.line.frequency, *line.line.decay_time}, multiplet->strain});
    }
  }
  return decays;
}

void add_damping(const MaterialFit& fit, Identification& result) {
  const std::vector<StrainedDecay> strained = strained_decays(result.lines, fit.model().multiplets());
  std::vector<Decay> decays;
  std::ranges::transform(strained, std::back_inserter(decays), &StrainedDecay::decay);
  const auto damping = fit_damping(decays);
  if (!damping) {
    return;
  }
  result.material.damping = *damping;
  result.has_damping = true;
  if (result.material.orthotropy) {
    const Eigen::Matrix3d axes = fit.model().axes_of(fit.material());
    const auto directional = fit_directional_loss(result.material, axes, strained);
    if (directional && directional->squares < squares_of(*damping, decays)) {
      result.material.damping = {.loss = directional->loss};
      result.material.damping.loss->band = band_around(decays);
    }
  }
}

}  // namespace

Identification identify(const scene::Solids& solids, const Measurements& measured,
                        const IdentificationOptions& options) {
  return identify(StrainedBody(solids, options.mass), measured, options);
}

Identification identify(StrainedBody body, const Measurements& measured, const IdentificationOptions& options) {
  MaterialFit fit(std::move(body), measured, options);
  Identification result;
  fit.run(result);
  add_lines(measured.lines, fit, options.tolerance, result);
  add_split_lines(result.lines);
  add_residuals(result);
  add_doubts(options.tolerance, result);
  add_damping(fit, result);
  return result;
}

}  // namespace idiophone::fitting
