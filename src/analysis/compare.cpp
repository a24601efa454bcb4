#include "idiophone/analysis/compare.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace idiophone::analysis {
namespace {

void check(const References& references, double tolerance) {
  for (const double frequency : references.frequencies) {
    if (!(frequency > 0.0) || !std::isfinite(frequency)) {
      throw std::invalid_argument(
          fmt::format("references \"{}\": {} Hz is not a positive frequency", references.name, frequency));
    }
  }
  if (!(tolerance > 0.0)) {
    throw std::invalid_argument(fmt::format("the tolerance must be positive, it is {} cents", tolerance));
  }
}

double percent(double frequency, double reference) {
  return 100.0 * (frequency / reference - 1.0);
}

std::string reference_columns(double frequency, const References& references, double tolerance) {
  const auto distance = [&](double reference) { return std::abs(cents(frequency, reference)); };
  const auto nearest = std::ranges::min_element(references.frequencies, {}, distance);
  if (nearest == references.frequencies.end()) {
    return {};
  }
  if (distance(*nearest) > tolerance) {
    return fmt::format("  {:>12}  {:>8}  {:>8}", "-", "-", "-");
  }
  return fmt::format("  {:>12.2f}  {:>+8.1f}  {:>+8.3f}", *nearest, cents(frequency, *nearest),
                     percent(frequency, *nearest));
}

}  // namespace

double cents(double frequency, double reference) {
  return 1200.0 * std::log2(frequency / reference);
}

std::vector<Match> match(std::span<const Partial> partials, const References& references, double tolerance) {
  check(references, tolerance);
  std::vector<Match> matches;
  for (const double reference : references.frequencies) {
    const auto distance = [&](const Partial& partial) { return std::abs(cents(partial.frequency, reference)); };
    const auto nearest = std::ranges::min_element(partials, {}, distance);
    Match found{.reference = reference, .partial = std::nullopt, .cents = 0.0, .percent = 0.0};
    if (nearest != partials.end() && distance(*nearest) <= tolerance) {
      found.partial = static_cast<std::size_t>(nearest - partials.begin());
      found.cents = cents(nearest->frequency, reference);
      found.percent = percent(nearest->frequency, reference);
    }
    matches.push_back(found);
  }
  return matches;
}

std::string table(std::span<const Partial> partials, const References& references, double tolerance) {
  const std::vector<Match> matches = match(partials, references, tolerance);
  std::string text = fmt::format("{:>12}  {:>9}  {:>8}", "frequency/Hz", "level/dB", "T60/s");
  if (!matches.empty()) {
    text += fmt::format("  {:>12}  {:>8}  {:>8}", "reference/Hz", "cents", "percent");
  }
  text += '\n';
  for (const Partial& partial : partials) {
    text += fmt::format("{:>12.2f}  {:>9.2f}  {:>8}{}\n", partial.frequency, partial.level,
                        partial.decay_time ? fmt::format("{:.3f}", *partial.decay_time) : "-",
                        reference_columns(partial.frequency, references, tolerance));
  }
  for (const Match& one : matches) {
    if (!one.partial) {
      fmt::format_to(std::back_inserter(text), "no partial within {:g} cents of {:.2f} Hz ({})\n", tolerance,
                     one.reference, references.name);
    }
  }
  return text;
}

}  // namespace idiophone::analysis
