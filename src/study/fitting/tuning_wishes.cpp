#include "tuning_wishes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "idiophone/study/partials/compare.hpp"

namespace idiophone::fitting {

namespace {

/// The band and some cents to each side, so that modes that are that deep in it are outside of the band.
Band widened(const Band& band, double cents) {
  return {band.lower * std::exp2(-cents / 1200), band.upper * std::exp2(cents / 1200)};
}

/// Cents from a frequency to the nearer end of the band that it is in; 0 outside.
double depth(double frequency, const Band& band) {
  return std::max(0.0, std::min(partials::cents(frequency, band.lower), partials::cents(band.upper, frequency)));
}

double depth(const std::vector<double>& frequencies, const Band& band) {
  double squares = 0.0;
  for (const double frequency : frequencies) {
    squares += std::pow(depth(frequency, band), 2);
  }
  return std::sqrt(squares);
}

}  // namespace

Wishes::Wishes(const Target& target, const TuningOptions& options)
    : target_(target), options_(options), numbers_(options.modes) {
  for (const WantedDecay& wanted : options.decays) {
    if (std::ranges::find(numbers_, wanted.mode) == numbers_.end()) {
      numbers_.push_back(wanted.mode);
    }
  }
  for (const Band& band : options.avoided) {
    for (const double frequency : target.values) {
      if (!target.are_ratios && depth(frequency, widened(band, options.tolerance)) > 0) {
        throw std::runtime_error(
            fmt::format("{:g} Hz is wanted, but {:g} to {:g} Hz is to be avoided", frequency, band.lower, band.upper));
      }
    }
  }
}

double Wishes::up_to() const {
  double highest = 0.0;
  for (const Band& band : options_.avoided) {
    highest = std::max(highest, widened(band, options_.tolerance).upper);
  }
  return highest;
}

double Wishes::decay_time(const TrackedModes& body, const WantedDecay& wanted) const {
  const auto place = std::ranges::find(numbers_, wanted.mode) - numbers_.begin();
  return body.body.decay_times[static_cast<std::size_t>(body.modes[static_cast<std::size_t>(place)])];
}

/// How far a level is from the wanted one, dB. One that is at the tolerance from a limit keeps the limit.
double Wishes::level_error(const WantedLevel& wanted, double level) const {
  const double above = level - wanted.level;
  switch (wanted.kind) {
    case WantedLevel::Kind::equal:
      return above;
    case WantedLevel::Kind::at_least:
      return std::min(0.0, above - options_.level_tolerance);
    case WantedLevel::Kind::at_most:
      return std::max(0.0, above + options_.level_tolerance);
  }
  return above;
}

Eigen::VectorXd Wishes::measures(const TrackedModes& body) const {
  std::vector<double> all;
  const Eigen::VectorXd cents = cents_above(target_, body);
  all.assign(cents.begin(), cents.end());
  for (const WantedDecay& wanted : options_.decays) {
    const double now = decay_time(body, wanted);
    if (!std::isfinite(now)) {
      throw std::runtime_error(
          fmt::format("mode {} has no decay time, because nothing damps it: give its material a damping, or the body "
                      "supports that damp",
                      wanted.mode));
    }
    all.push_back(100 * std::log(now / wanted.decay_time) * cents_per_percent());
  }
  for (std::size_t i = 0; i < options_.levels.size(); ++i) {
    all.push_back(level_error(options_.levels[i], body.body.levels[i]) * cents_per_decibel());
  }
  for (const Band& band : options_.avoided) {
    all.push_back(depth(body.body.frequencies, widened(band, options_.tolerance)));
  }
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

Eigen::MatrixXd Wishes::errors(Eigen::MatrixXd measures) const {
  if (target_.are_ratios) {
    measures.topRows(static_cast<Eigen::Index>(target_.values.size())).rowwise() -= measures.row(0).eval();
  }
  return measures;
}

Eigen::MatrixXd Wishes::residuals(const Eigen::MatrixXd& measures) const {
  const Eigen::MatrixXd all = errors(measures);
  return target_.are_ratios ? Eigen::MatrixXd(all.bottomRows(all.rows() - 1)) : all;
}

std::vector<TunedDecay> Wishes::decays(const TrackedModes& start, const TrackedModes& body,
                                       const Eigen::MatrixXd& slopes) const {
  std::vector<TunedDecay> found;
  for (const WantedDecay& wanted : options_.decays) {
    const auto place = std::ranges::find(numbers_, wanted.mode) - numbers_.begin();
    const double now = decay_time(body, wanted);
    const Eigen::VectorXd percents =
        slopes.row(static_cast<Eigen::Index>(target_.values.size() + found.size())) / cents_per_percent();
    found.push_back({.start_mode = wanted.mode,
                     .mode = body.modes[static_cast<std::size_t>(place)] + 1,
                     .start = decay_time(start, wanted),
                     .decay_time = now,
                     .wanted = wanted.decay_time,
                     .percent = 100 * (now / wanted.decay_time - 1),
                     .sensitivities = {percents.begin(), percents.end()}});
  }
  return found;
}

std::vector<TunedLevel> Wishes::levels(const ModeShapes& start, const ModeShapes& body,
                                       const Eigen::MatrixXd& slopes) const {
  std::vector<TunedLevel> found;
  for (std::size_t i = 0; i < options_.levels.size(); ++i) {
    const Eigen::VectorXd decibels =
        slopes.row(static_cast<Eigen::Index>(target_.values.size() + options_.decays.size() + i)) / cents_per_decibel();
    found.push_back(
        {.wanted = options_.levels[i],
         .start = start.levels[i],
         .level = body.levels[i],
         .is_reached = std::abs(level_error(options_.levels[i], body.levels[i])) <= options_.level_tolerance,
         .sensitivities = {decibels.begin(), decibels.end()}});
  }
  return found;
}

std::vector<AvoidedBand> Wishes::avoided(const ModeShapes& body) const {
  std::vector<AvoidedBand> found;
  for (const Band& band : options_.avoided) {
    AvoidedBand& now = found.emplace_back(AvoidedBand{.band = band});
    for (std::size_t mode = 0; mode < body.frequencies.size(); ++mode) {
      if (depth(body.frequencies[mode], band) > 0) {
        now.modes.push_back(static_cast<int>(mode) + 1);
        now.frequencies.push_back(body.frequencies[mode]);
      }
    }
  }
  return found;
}

}  // namespace idiophone::fitting
