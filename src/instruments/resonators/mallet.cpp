#include "idiophone/instruments/resonators/mallet.hpp"

#include <algorithm>
#include <cmath>

#include "bracketed_root.hpp"

namespace idiophone::resonators {

Mallet::Mallet(const score::Hammer& hammer, double loss, int rate)
    : hammer_(hammer), loss_(loss), step_(1.0 / rate), speed_(hammer.speed) {}

double Mallet::stored(double approach) const {
  return 0.4 * hammer_.hardness * std::pow(std::max(0.0, approach), 2.5);
}

double Mallet::force_of(double change) const {
  constexpr double smallest = 1e-7;  // of the approach, in whose change the difference of energies has no digits left
  const double mean = hammer_.hardness * std::pow(std::max(0.0, approach_ + 0.5 * change), 1.5);
  const double elastic = std::abs(change) > smallest * std::abs(approach_)
                             ? (stored(approach_ + change) - stored(approach_)) / change
                             : mean;
  return std::max(0.0, elastic + loss_ * mean * change / step_);
}

/// The approach changes by the mallet's way, which is exact for a constant force, less that of the point.
double Mallet::force(double free, double compliance) const {
  const double free_change = speed_ * step_ - free;
  const double yield = compliance + 0.5 * step_ * step_ / hammer_.mass;
  const double change = root_from([&](double tried) { return tried - free_change + yield * force_of(tried); }, 0.0);
  return force_of(change);
}

void Mallet::advance(double way, double force) {
  const double slower = speed_ - force * step_ / hammer_.mass;
  approach_ += 0.5 * (speed_ + slower) * step_ - way;
  deepest_ = std::max(deepest_, approach_);
  speed_ = slower;
}

bool Mallet::is_over() const {
  return speed_ < 0.0 && approach_ < -5.0 * deepest_;
}

}  // namespace idiophone::resonators
