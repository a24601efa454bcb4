#include "idiophone/instruments/resonators/friction.hpp"

#include <cmath>

#include "bracketed_root.hpp"

namespace idiophone::resonators {

ElastoPlasticFriction::ElastoPlasticFriction(const score::Friction& law, double step) : law_(law), step_(step) {}

double ElastoPlasticFriction::sliding_deflection(double velocity, double load) const {
  const double ratio = velocity / law_.stribeck_speed;
  const double coefficient = law_.sliding + (law_.sticking - law_.sliding) * std::exp(-ratio * ratio);
  return load * coefficient / law_.stiffness;
}

/// The mean y solves y + h |v| a(y) y/(2 z_v) = z + h v/2, taken positive in the direction of v.
double ElastoPlasticFriction::mean_deflection(double velocity, double load) const {
  const double sign = velocity < 0.0 ? -1.0 : 1.0;
  const double before = sign * deflection_, half_way = 0.5 * step_ * std::abs(velocity);
  const double free = before + half_way;
  const double sliding = sliding_deflection(velocity, load);
  const double breaks = law_.break_away * load * law_.sliding / law_.stiffness;
  if (free <= breaks) {
    return sign * free;
  }
  if (before >= sliding) {
    return sign * free * sliding / (sliding + half_way);
  }
  const double square = half_way / (sliding * (sliding - breaks)), linear = 1.0 - square * breaks;
  return sign * 2.0 * free / (linear + std::sqrt(linear * linear + 4.0 * square * free));
}

double ElastoPlasticFriction::force(double velocity, double load) const {
  if (load <= 0.0) {
    return 0.0;
  }
  const double mean = mean_deflection(velocity, load);
  const double rate = 2.0 * (mean - deflection_) / step_;
  const double damping = law_.damping / (1.0 + 0.25 * law_.damping * std::abs(velocity) / (law_.sliding * load));
  return law_.stiffness * mean + damping * rate + law_.viscosity * velocity;
}

double ElastoPlasticFriction::velocity(double free, double mobility, double load) const {
  return root_from([&](double tried) { return tried - free + mobility * force(tried, load); }, velocity_);
}

void ElastoPlasticFriction::advance(double velocity, double load) {
  velocity_ = velocity;
  deflection_ = load > 0.0 ? 2.0 * mean_deflection(velocity, load) - deflection_ : 0.0;
}

}  // namespace idiophone::resonators
