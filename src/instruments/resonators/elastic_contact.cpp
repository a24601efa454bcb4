#include "idiophone/instruments/resonators/elastic_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "idiophone/foundation/bracketed_root.hpp"

namespace idiophone::resonators {

ElasticContact::ElasticContact(const score::Elasticity& law, scene::Course gap, const Mass& mass, int rate)
    : law_(law),
      gap_(std::move(gap)),
      energy_scale_(1.0 / (law.exponent + 1.0) * law.hardness),
      mass_(mass),
      step_(1.0 / rate),
      approach_(-this->gap(0)) {
  look_ahead();
}

double ElasticContact::stored(double approach) const {
  return energy_scale_ * std::pow(std::max(0.0, approach), law_.exponent + 1.0);
}

double ElasticContact::force_of(double change) const {
  constexpr double smallest = 1e-7;  // of the approach, in whose change the difference of energies has no digits left
  const double mean = law_.hardness * std::pow(std::max(0.0, approach_ + 0.5 * change), law_.exponent);
  const double elastic = std::abs(change) > smallest * std::abs(approach_)
                             ? (stored(approach_ + change) - stored(approach_)) / change
                             : mean;
  return std::max(0.0, elastic + law_.loss * mean * change / step_);
}

double ElasticContact::risen(std::int64_t sample) const {
  constexpr double ramp = 0.01;  // s
  return std::min(1.0, static_cast<double>(sample) * step_ / ramp);
}

double ElasticContact::gap(std::int64_t sample) const {
  const double wanted = gap_.at(static_cast<double>(sample) * step_);
  return wanted < 0.0 ? wanted * risen(sample) : wanted;
}

void ElasticContact::look_ahead() {
  closing_ = gap(now_) - gap(now_ + 1);
  load_ = mass_.load * risen(now_);
}

/// The approach changes by the way of the mass, which is exact for a constant force, less that of the point.
double ElasticContact::force(double free, double compliance) const {
  const double pushed = closing_ + 0.5 * load_ / mass_.mass * step_ * step_;
  const double free_change = mass_.speed * step_ - free + pushed;
  if (approach_ <= 0.0 && approach_ + free_change <= 0.0) {
    return 0.0;
  }
  const double yield = compliance + 0.5 * step_ * step_ / mass_.mass;
  const double change = root_from([&](double tried) { return tried - free_change + yield * force_of(tried); }, 0.0);
  return force_of(change);
}

void ElasticContact::advance(double way, double force) {
  const double slower = mass_.speed - (force - load_) * step_ / mass_.mass;
  approach_ += 0.5 * (mass_.speed + slower) * step_ - way + closing_;
  deepest_ = std::max(deepest_, approach_);
  mass_.speed = slower;
  ++now_;
  look_ahead();
}

bool ElasticContact::is_at_rest() const {
  const bool is_set = static_cast<double>(now_) * step_ >= gap_.points.back().time && gap(now_) == gap_.last();
  return is_set && approach_ <= 0.0 && std::isinf(mass_.mass);
}

}  // namespace idiophone::resonators
