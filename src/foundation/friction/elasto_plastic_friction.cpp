#include "idiophone/foundation/friction/elasto_plastic_friction.hpp"

#include <cmath>

#include "idiophone/foundation/bracketed_root.hpp"

namespace idiophone::friction {

ElastoPlasticFriction::ElastoPlasticFriction(const Law& law, double step, Deflection deflection)
    : law_(law), share_(deflection == Deflection::mean ? 0.5 : 1.0), reach_(share_ * step) {}

double ElastoPlasticFriction::sliding_deflection(double velocity, double load) const {
  const double ratio = velocity / law_.stribeck_speed;
  const double coefficient = law_.sliding + (law_.sticking - law_.sliding) * std::exp(-ratio * ratio);
  return load * coefficient / law_.stiffness;
}

/// With the way w = reach |v|, it is the y that solves y + w a(y) y/z_v = z + w, taken positive in the direction of v.
double ElastoPlasticFriction::used_deflection(double velocity, double load) const {
  const double sign = velocity < 0.0 ? -1.0 : 1.0;
  const double before = sign * deflection_, way = reach_ * std::abs(velocity);
  const double free = before + way;
  const double sliding = sliding_deflection(velocity, load);
  const double breaks = law_.break_away * load * law_.sliding / law_.stiffness;
  if (free <= breaks) {
    return sign * free;
  }
  if (before >= sliding) {
    return sign * free * sliding / (sliding + way);
  }
  const double square = way / (sliding * (sliding - breaks)), linear = 1.0 - square * breaks;
  return sign * 2.0 * free / (linear + std::sqrt(linear * linear + 4.0 * square * free));
}

double ElastoPlasticFriction::force(double velocity, double load) const {
  if (load <= 0.0) {
    return 0.0;
  }
  const double used = used_deflection(velocity, load);
  const double rate = (used - deflection_) / reach_;
  const double damping = law_.damping / (1.0 + 0.25 * law_.damping * std::abs(velocity) / (law_.sliding * load));
  return law_.stiffness * used + damping * rate + law_.viscosity * velocity;
}

double ElastoPlasticFriction::velocity(double free, double mobility, double load) const {
  return root_from([&](double tried) { return tried - free + mobility * force(tried, load); }, velocity_);
}

void ElastoPlasticFriction::advance(double velocity, double load) {
  velocity_ = velocity;
  deflection_ = load > 0.0 ? (used_deflection(velocity, load) - (1.0 - share_) * deflection_) / share_ : 0.0;
}

}  // namespace idiophone::friction
