#include "tap_expectation.hpp"

#include <algorithm>
#include <cmath>

#include "idiophone/study/bench/cut_plan.hpp"
#include "idiophone/study/bench/tap_place.hpp"
#include "idiophone/study/partials/compare.hpp"

namespace idiophone::bench {

namespace {

constexpr double common_deviation = 300.0;  // cents: density, size, and a factor of all moduli
constexpr double of_unknown_place = 0.8;    // probability that a mode is heard
constexpr double of_lively_place = 0.95;
constexpr double of_silent_place = 0.02;
constexpr double of_lost_mode = 1e-6;

double pitch_of(const eigenmodes::Mode& mode) {
  return partials::cents(mode.frequency, 1.0);
}

double probability_of(const Workpiece::Solved& body, const Side& side, std::size_t place, const Tap& tap) {
  if (!tap.at) {
    return of_unknown_place;
  }
  return tapped_share(body, side, place, tapped_node(body.mesh, *tap.at)) > silent_share ? of_lively_place
                                                                                         : of_silent_place;
}

}  // namespace

TapExpectations::TapExpectations(const Workpiece& piece, const std::vector<Cut>& made, const Beliefs& beliefs)
    : piece_(piece), made_(made), beliefs_(beliefs), uncut_(piece.material_slopes_of(piece.uncut())) {
  unknowns_ = {uncut_.names, piece.uncut().modes.size(), made.size()};
  before_.resize(static_cast<Eigen::Index>(unknowns_.modes));
  std::ranges::transform(piece.uncut().modes, before_.begin(), pitch_of);
}

ExpectedTap TapExpectations::of(const Tap& tap) {
  const std::vector<Cut> cuts(made_.begin(), made_.begin() + static_cast<std::ptrdiff_t>(tap.cuts));
  const Workpiece::Solved body = piece_.with(cuts);
  std::vector<std::size_t> all(body.modes.size());
  std::ranges::generate(all, [n = std::size_t{0}]() mutable { return n++; });
  strips_ = piece_.slopes_of(body, all).strips;
  const fitting::MaterialSlopes material = piece_.material_slopes_of(body);
  ExpectedTap expected{before_, Eigen::MatrixXd::Zero(before_.size(), unknowns_.size()),
                       Eigen::VectorXd::Zero(unknowns_.size()), std::vector<double>(unknowns_.modes, of_lost_mode)};
  for (std::size_t mode = 0; mode < unknowns_.modes; ++mode) {
    const auto row = static_cast<Eigen::Index>(mode);
    expected.slopes(row, TapUnknowns::shift) = 1.0;
    expected.slopes(row, unknowns_.own(mode)) = 1.0;
    if (body.places[mode]) {
      expected.slopes.row(row).segment(unknowns_.constant(0), material.cents.cols()) =
          material.cents.row(static_cast<Eigen::Index>(*body.places[mode]));
      set_mode(expected, mode, body, tap);
    }
  }
  set_spread(expected, tap);
  before_ = expected.cents;
  cuts_before_ = tap.cuts;
  is_first_ = false;
  return expected;
}

void TapExpectations::set_mode(ExpectedTap& expected, std::size_t mode, const Workpiece::Solved& body,
                               const Tap& tap) const {
  const std::size_t place = *body.places[mode];
  const auto row = static_cast<Eigen::Index>(mode);
  const auto of_body = static_cast<Eigen::Index>(place);
  expected.cents[row] = pitch_of(body.modes[place]);
  expected.heard[mode] = probability_of(body, piece_.side(), place, tap);
  expected.slopes(row, TapUnknowns::thickness) = strips_.slopes.row(of_body).sum();
  for (std::size_t cut = 0; cut < tap.cuts; ++cut) {
    expected.slopes(row, unknowns_.depth(cut)) =
        modelled_depth_slope(made_[cut]) * slopes_of(strips_, made_[cut].tool, made_[cut].place)[of_body];
  }
}

void TapExpectations::set_spread(ExpectedTap& expected, const Tap& tap) {
  if (is_first_) {
    expected.spread[TapUnknowns::shift] = common_deviation;
    expected.spread[TapUnknowns::thickness] = beliefs_.depth_error;
    expected.spread.segment(unknowns_.constant(0), uncut_.deviations.size()) = uncut_.deviations;
  }
  Eigen::VectorXd by_cuts = beliefs_.slope_error * (expected.cents - before_);
  for (std::size_t cut = cuts_before_; cut < tap.cuts; ++cut) {
    by_cuts.array() = by_cuts.array().abs() + doubt_of(made_[cut].tool, piece_.thinnest()) * made_[cut].depth *
                                                  expected.slopes.col(unknowns_.depth(cut)).array().abs();
  }
  for (std::size_t mode = 0; mode < unknowns_.modes; ++mode) {
    const double spread = by_cuts[static_cast<Eigen::Index>(mode)];
    expected.spread[unknowns_.own(mode)] = is_first_ ? std::hypot(beliefs_.own, spread) : std::abs(spread);
  }
  for (std::size_t cut = cuts_before_; cut < tap.cuts; ++cut) {
    expected.spread[unknowns_.depth(cut)] = beliefs_.depth_error;
  }
}

}  // namespace idiophone::bench
