#include "idiophone/study/fitting/identification.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "assignment.hpp"
#include "fit_damping.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "material_fit.hpp"

namespace idiophone::fitting {

namespace {

std::optional<double> rms_of(const std::vector<AssignedLine>& lines, bool fitted) {
  double sum = 0.0;
  int count = 0;
  for (const AssignedLine& line : lines) {
    if (line.modes > 0 && line.is_fitted == fitted && !line.is_split) {
      sum += line.cents * line.cents;
      ++count;
    }
  }
  return count == 0 ? std::nullopt : std::optional(std::sqrt(sum / count));
}

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

void add_damping(Identification& result) {
  std::vector<Decay> decays;
  for (const AssignedLine& line : result.lines) {
    if (line.modes > 0 && line.line.decay_time) {
      decays.push_back({line.line.frequency, *line.line.decay_time});
    }
  }
  if (const auto damping = fit_damping(decays)) {
    result.material.damping = *damping;
    result.has_damping = true;
  }
}

/// Says why the fit is not accepted.
void add_doubts(const std::vector<AssignedLine>& lines, double tolerance, std::vector<std::string>& doubts) {
  constexpr double too_far = 3.0;  // of the root mean square of the distances over the uncertainties
  std::vector<double> false_lines;
  double squares = 0.0, allowed = 0.0, sum = 0.0, mesh = 0.0;
  int fitted = 0;
  for (const AssignedLine& line : lines) {
    if (line.modes == 0) {
      false_lines.push_back(line.line.frequency);
    } else if (line.is_fitted) {
      ++fitted;
      squares += std::pow(line.cents / line.line.uncertainty, 2);
      allowed += std::pow(line.line.uncertainty, 2);
      sum += std::pow(line.cents, 2);
      mesh = std::max(mesh, line.mesh_error);
    }
  }
  if (!false_lines.empty()) {
    doubts.push_back(fmt::format("{} of {} lines are no mode of the body within {:g} cents: {:g} Hz",
                                 false_lines.size(), lines.size(), tolerance, fmt::join(false_lines, ", ")));
  }
  if (squares > too_far * too_far * fitted) {
    doubts.push_back(fmt::format(
        "the fitted lines are {:.1f} cents away from their modes (root mean square), and their uncertainties "
        "are {:.1f}; the mesh may make a mode wrong by {:.1f}",
        std::sqrt(sum / fitted), std::sqrt(allowed / fitted), mesh));
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
  result.fitted_rms = rms_of(result.lines, true);
  result.tested_rms = rms_of(result.lines, false);
  add_doubts(result.lines, options.tolerance, result.doubts);
  add_damping(result);
  return result;
}

}  // namespace idiophone::fitting
