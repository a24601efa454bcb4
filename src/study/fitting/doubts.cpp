#include "doubts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "confidence.hpp"

namespace idiophone::fitting {

namespace {

bool is_fitted(const AssignedLine& line) {
  return line.is_fitted && line.modes > 0;
}

bool is_predicted(const AssignedLine& line) {
  return !line.is_fitted && line.modes > 0 && !line.is_split;
}

/// Root of the mean square of a number of some lines; none if there are no such lines.
template <class Choice, class Number>
std::optional<double> rms_of(const std::vector<AssignedLine>& lines, const Choice& is_chosen, const Number& number) {
  double sum = 0.0;
  int count = 0;
  for (const AssignedLine& line : lines) {
    if (is_chosen(line)) {
      sum += std::pow(number(line), 2);
      ++count;
    }
  }
  return count == 0 ? std::nullopt : std::optional(std::sqrt(sum / count));
}

double cents_of(const AssignedLine& line) {
  return line.cents;
}

void doubt_false_lines(double tolerance, Identification& result) {
  std::vector<double> false_lines;
  for (const AssignedLine& line : result.lines) {
    if (line.modes == 0) {
      false_lines.push_back(line.line.frequency);
    }
  }
  if (!false_lines.empty()) {
    result.doubts.push_back(fmt::format("{} of {} lines are no mode of the body within {:g} cents: {:g} Hz",
                                        false_lines.size(), result.lines.size(), tolerance,
                                        fmt::join(false_lines, ", ")));
  }
}

/// A fit in a wrong minimum has such residuals, or one of a body that is not the deck's. Large errors of the mesh can
/// hide both, so what only they explain is not accepted either.
void doubt_large_residuals(Identification& result) {
  if (!result.fitted_rms) {
    return;
  }
  const double uncertainty = *rms_of(result.lines, is_fitted, [](const auto& line) { return line.line.uncertainty; });
  const double mesh_error = *rms_of(result.lines, is_fitted, [](const auto& line) { return line.mesh_error; });
  const double limit = largest_believable(result.freedom);
  const double times_uncertainty =
      *rms_of(result.lines, is_fitted, [](const auto& line) { return line.cents / line.line.uncertainty; });
  constexpr double most_uncertainties = 3.0;
  if (result.chi_squared > limit) {
    result.doubts.push_back(fmt::format(
        "the fitted lines are {:.1f} cents away from their modes, and their uncertainties are {:.1f} and the errors of "
        "the mesh {:.1f} (root mean squares). Chi-squared is {:.1f}, with {} degrees of freedom; in 999 of 1000 right "
        "fits it is below {:.1f}. The search may have ended in a wrong minimum: begin with other values in the deck. "
        "Or the lines, or the size and the mass of the body, are less exact than stated: uncertainties and errors of "
        "the mesh "
        "{:.1f} times as large explain the distances",
        *result.fitted_rms, uncertainty, mesh_error, result.chi_squared, result.freedom, limit,
        std::sqrt(result.chi_squared / result.freedom)));
  } else if (times_uncertainty > most_uncertainties) {
    result.doubts.push_back(
        fmt::format("the fitted lines are {:.1f} cents away from their modes, and their uncertainties are {:.1f} (root "
                    "mean squares). The "
                    "errors of the mesh, {:.1f}, may explain that, or hide a wrong fit: make the mesh finer",
                    *result.fitted_rms, uncertainty, mesh_error));
  }
}

}  // namespace

void add_residuals(Identification& result) {
  result.fitted_rms = rms_of(result.lines, is_fitted, cents_of);
  result.tested_rms = rms_of(result.lines, is_predicted, cents_of);
  const auto fitted = std::ranges::count_if(result.lines, is_fitted);
  for (const AssignedLine& line : result.lines) {
    result.chi_squared +=
        is_fitted(line) ? std::pow(line.cents / std::hypot(line.line.uncertainty, line.mesh_error), 2) : 0.0;
  }
  const auto constants = std::ranges::count(result.constants, true, &IdentifiedConstant::determined);
  result.freedom = static_cast<int>(std::max<std::ptrdiff_t>(1, fitted - constants));
}

void add_doubts(double tolerance, Identification& result) {
  doubt_false_lines(tolerance, result);
  doubt_large_residuals(result);
}

}  // namespace idiophone::fitting
