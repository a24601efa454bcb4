#include "stretching_force.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::modal_bodies {

namespace {

constexpr double offset_in_energies = 2.0;  // of modes and stretching together, or of stretching below zero
constexpr double correction = 500.0;        // share of a drift that is taken back in a second
constexpr double smallest_place = 1e-16;    // kg^1/2 m; squares of smaller ones would be denormal
constexpr double smallest_energy = 1e-40;   // J

/// That the linear recurrence conserves without damping, J.
double energy_of_modes(const ModalStep& step, const Eigen::ArrayXd& begin, const Eigen::ArrayXd& end) {
  return ((step.stiffness * (end - begin).square()).sum() + (step.squares * begin * end).sum()) / 2;
}

}  // namespace

StretchingForce::StretchingForce(const Stretching& stretching) {
  if (stretching.exists() && stretching.terms() > 0) {
    const std::size_t modes = stretching.linear.size() / stretching.terms();
    energy_.emplace(stretching.linear, stretching.quadratic, modes);
    places_.resize(modes);
    slopes_.resize(modes);
    go_to(Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(modes)));
  }
}

void StretchingForce::go_to(const Eigen::ArrayXd& places) {
  std::ranges::transform(places, places_.begin(), [](double place) {
    return std::abs(place) < smallest_place ? 0.0F : static_cast<float>(place);
  });
  value_ = energy_->at(places_, 1.0F, slopes_);
  gradient_ = Eigen::Map<const Eigen::ArrayXf>(slopes_.data(), std::ssize(slopes_)).cast<double>();
}

StretchedStep StretchingForce::step(const ModalStep& step, double stored) const {
  const double energy = std::max(energy_of_modes(step, step.before, step.now), 0.0);
  // The sum is nearly zero where a shell snapped through: it has as much less stored than at rest as its modes have.
  const double offset = std::max({offset_in_energies * (energy + stored), -offset_in_energies * value_, -stored});
  const double root = std::sqrt(2 * (stored + offset));
  const double level = std::sqrt(2 * std::max(value_ + offset, smallest_energy));
  const Eigen::ArrayXd way = (step.end - step.before) / 2;
  Eigen::ArrayXd g = gradient_ / level;
  // A part of g along the way lets p approach sqrt(2 (V + offset)). What p gets the modes lose.
  const double drift = level - (root + (g * way).sum() / 2);
  const double most = std::max({energy, energy_of_modes(step, step.now, step.end), smallest_energy});
  g += correction * drift / (2 * most * step.length) * way;
  const Eigen::ArrayXd pull = g / step.stiffness;
  const double mean = (root + (g * way).sum() / 2) / (1 + (g * pull).sum() / 4);
  const double after = 2 * mean - root;
  return {.change = -mean * pull, .stored = after * after / 2 - offset};
}

}  // namespace idiophone::modal_bodies
