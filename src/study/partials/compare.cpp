#include "idiophone/study/partials/compare.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace idiophone::partials {
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

std::size_t width(const References& references) {
  return std::max<std::size_t>(references.name.size(), 8);
}

/// A line for each reference without a partial.
std::string missing(std::span<const Partial> partials, const References& references, double tolerance) {
  std::string text;
  for (const Match& one : match(partials, references, tolerance)) {
    if (!one.partial) {
      text +=
          fmt::format("no partial within {:g} cents of {:.2f} Hz ({})\n", tolerance, one.reference, references.name);
    }
  }
  return text;
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

std::optional<double> cents_from_nearest(double frequency, const References& references, double tolerance) {
  std::optional<double> least;
  for (const double reference : references.frequencies) {
    const double distance = cents(frequency, reference);
    if (std::abs(distance) <= (least ? std::abs(*least) : tolerance)) {
      least = distance;
    }
  }
  return least;
}

std::string cents_head(const References& references) {
  return fmt::format("  {:>{}}", references.name, width(references));
}

std::string cents_cell(std::optional<double> cents, const References& references) {
  return fmt::format("  {:>{}}", cents ? fmt::format("{:+.1f}", *cents) : "-", width(references));
}

double sound_pressure_level(double level) {
  return level - 20.0 * std::log10(std::numbers::sqrt2 * 20e-6);
}

std::string table(std::span<const Partial> partials, std::span<const References> sets, double tolerance,
                  SampleUnit unit) {
  const bool pressure = unit == SampleUnit::pascal;
  std::string text =
      fmt::format("{:>12}  {:>9}{}  {:>8}", "frequency/Hz", "level/dB", pressure ? "    SPL/dB" : "", "T60/s");
  std::string without_partial;
  for (const References& references : sets) {
    text += cents_head(references);
    without_partial += missing(partials, references, tolerance);
  }
  text += '\n';
  for (const Partial& partial : partials) {
    text += fmt::format("{:>12.2f}  {:>9.2f}{}  {:>8}", partial.frequency, partial.level,
                        pressure ? fmt::format("  {:>8.1f}", sound_pressure_level(partial.level)) : "",
                        partial.decay_time ? fmt::format("{:.3f}", *partial.decay_time) : "-");
    for (const References& references : sets) {
      text += cents_cell(cents_from_nearest(partial.frequency, references, tolerance), references);
    }
    if (partial.remainder) {
      text += fmt::format("  not a single one: {:.0f} dB remain", *partial.remainder);
    }
    text += '\n';
  }
  return text + without_partial;
}

}  // namespace idiophone::partials
